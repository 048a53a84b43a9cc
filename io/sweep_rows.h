// The rows of sweep.csv, collected while it is still open which columns there will be.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/name_places.h"
#include "io/scratch_file.h"
#include "io/streamed_file.h"
#include "io/sweep_results.h"

namespace brachium {

// Held on the disk: in memory a row costs no more than its lengths.
class SweepRows {
 public:
  // For the sweep in that folder. Throws OutputError, as do all below.
  explicit SweepRows(const std::string& folder) : text_(folder) {}

  void Append(const SweepTask& task, const std::optional<SweepResult>& result);

  // Of any result so far, in the order of their appearance.
  const std::vector<std::string>& figures() const { return figures_.names(); }

  // The header and all rows, each filled up to all columns. At most once.
  void WriteTo(StreamedFile* csv);

 private:
  struct Row {
    std::size_t head, tail;        // bytes: as far as the varied options, and from there on
    std::size_t options, figures;  // columns known when it was written
  };

  std::string Head(const SweepTask& task);
  std::string Tail(const std::optional<SweepResult>& result);

  NamePlaces options_, figures_;
  std::vector<Row> rows_;
  ScratchFile text_;
};

}  // namespace brachium
