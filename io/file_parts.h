// A long file, read in parts as they are asked for, so that it costs no memory.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace brachium {

class FileParts {
 public:
  // Throws InputError when it cannot be opened or is not a regular file.
  explicit FileParts(const std::string& path);
  ~FileParts();
  FileParts(const FileParts&) = delete;
  FileParts& operator=(const FileParts&) = delete;

  std::size_t size() const { return size_; }  // [byte], when it was opened

  // From any thread. Throws InputError when the file does not have them any more.
  std::string Read(std::size_t start, std::size_t bytes) const;

  // Part by part from the start to the end.
  void ForEach(const std::function<void(std::string_view)>& visit) const;

 private:
  std::string path_;
  int fd_;
  std::size_t size_ = 0;
};

}  // namespace brachium
