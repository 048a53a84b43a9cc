// Text put aside on the disk, to be read back once: a file without a name, gone with its object.
#pragma once

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

namespace brachium {

class ScratchFile {
 public:
  // On the disk that `folder` is on. Throws OutputError, as do all below.
  explicit ScratchFile(const std::string& folder);

  void Append(std::string_view text);

  void Rewind();                        // to the start, after the last Append()
  std::string Next(std::size_t bytes);  // that many, and on behind them

 private:
  [[noreturn]] void Fail() const;

  std::string folder_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

}  // namespace brachium
