#include "io/file_parts.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "io/input_error.h"

namespace brachium {
namespace {

constexpr std::size_t kPart = 1 << 20;  // [byte]

[[noreturn]] void FailReading(const std::string& path, const std::string& why) {
  throw InputError(path, 0, "cannot be read (" + why + ")");
}

}  // namespace

FileParts::FileParts(const std::string& path)
    : path_(path), fd_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
  struct stat status {};
  if (fd_ < 0 || fstat(fd_, &status) != 0) FailReading(path, std::strerror(errno));
  if (!S_ISREG(status.st_mode)) {
    close(fd_);
    throw InputError(path, 0, "is not a file; expected a regular file");
  }
  size_ = static_cast<std::size_t>(status.st_size);
}

FileParts::~FileParts() { close(fd_); }

std::string FileParts::Read(std::size_t start, std::size_t bytes) const {
  std::string text(bytes, '\0');
  for (std::size_t read = 0; read < bytes;) {
    const ssize_t more =
        pread(fd_, text.data() + read, bytes - read, static_cast<off_t>(start + read));
    if (more < 0 && errno == EINTR) continue;
    if (more < 0) FailReading(path_, std::strerror(errno));
    if (more == 0) FailReading(path_, "it was shortened meanwhile");
    read += static_cast<std::size_t>(more);
  }
  return text;
}

void FileParts::ForEach(const std::function<void(std::string_view)>& visit) const {
  for (std::size_t start = 0; start < size_; start += kPart)
    visit(Read(start, std::min(kPart, size_ - start)));
}

}  // namespace brachium
