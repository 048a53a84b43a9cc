#include "io/streamed_file.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "io/file_parts.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBuffer = 1 << 20;  // [byte]

std::string DraftOf(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  std::error_code error;
  if (!folder.empty()) fs::create_directories(folder, error);
  if (error) throw OutputError(folder.string() + ": cannot be written (" + error.message() + ")");
  return path + ".partial." + std::to_string(getpid());
}

bool HaveTheSameBytes(const std::string& a, const std::string& b) {
  const FileParts one(a), other(b);
  bool same = one.size() == other.size();
  std::size_t start = 0;
  one.ForEach([&](std::string_view part) {
    same = same && part == other.Read(start, part.size());
    start += part.size();
  });
  return same;
}

}  // namespace

StreamedFile::StreamedFile(const std::string& path)
    : path_(path), draft_(DraftOf(path)), file_(draft_) {}

StreamedFile::~StreamedFile() {
  std::error_code ignored;
  fs::remove(draft_, ignored);
}

void StreamedFile::Append(std::string_view text) {
  buffer_ += text;
  if (buffer_.size() > kBuffer) Flush();
}

void StreamedFile::Flush() {
  file_.Append(buffer_);
  buffer_.clear();
}

void StreamedFile::Commit(bool overwrite, const std::string& why) {
  Flush();
  file_.Close();
  std::error_code error;
  if (fs::is_regular_file(path_, error)) {
    if (HaveTheSameBytes(path_, draft_)) return;
    if (!overwrite) throw OutputExists(path_ + ": " + why);
  }
  if (std::rename(draft_.c_str(), path_.c_str()) != 0)
    throw OutputError(path_ + ": cannot be written (" + std::strerror(errno) + ")");
}

}  // namespace brachium
