// A long table of numbers, a block of rows at a time.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "io/csv.h"
#include "io/file_parts.h"

namespace brachium {

class CsvBlocks {
 public:
  // `file`: the name that errors carry, and where it lies. `watch` sees all bytes once, in order.
  // Throws InputError.
  CsvBlocks(const std::string& file, ColumnFilter wanted,
            std::function<void(std::string_view)> watch = {});

  // The next rows, under their lines of the file, some 2^18 bytes of them; none after the last. All
  // that ParseCsv refuses in the whole is refused in the block that holds it.
  std::optional<CsvTable> Next();

 private:
  bool ReadPart();
  std::size_t WholeLines() const;

  std::string file_;
  ColumnFilter wanted_;
  std::function<void(std::string_view)> watch_;
  FileParts parts_;
  std::size_t read_ = 0;  // [byte]
  std::string text_;      // read and not parsed yet
  std::vector<std::string> names_;
  std::size_t line_ = 1;  // of the file, on which `text_` begins
};

}  // namespace brachium
