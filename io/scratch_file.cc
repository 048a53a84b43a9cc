#include "io/scratch_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "io/output_folder.h"

namespace brachium {

ScratchFile::ScratchFile(const std::string& folder) : folder_(folder), file_(nullptr, std::fclose) {
  const std::string path = folder + "/.scratch.partial." + std::to_string(getpid());
  file_.reset(std::fopen(path.c_str(), "w+e"));
  if (!file_ || std::remove(path.c_str()) != 0) Fail();
}

void ScratchFile::Append(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) Fail();
}

void ScratchFile::Rewind() {
  if (std::fseek(file_.get(), 0, SEEK_SET) != 0) Fail();
}

std::string ScratchFile::Next(std::size_t bytes) {
  std::string text(bytes, '\0');
  if (std::fread(text.data(), 1, bytes, file_.get()) != bytes) Fail();
  return text;
}

void ScratchFile::Fail() const {
  throw OutputError(folder_ + ": nothing can be put aside there (" + std::strerror(errno) + ")");
}

}  // namespace brachium
