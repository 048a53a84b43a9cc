// A file's bytes, to be read once and looked at twice: by a reader and by a checksum.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

struct evp_md_ctx_st;  // of OpenSSL

namespace brachium {

// A regular file, mapped read-only for as long as this lives. Throws InputError when it cannot be
// opened or is not a regular file. The file must not be shortened meanwhile.
class FileBytes {
 public:
  explicit FileBytes(const std::string& path);
  ~FileBytes();
  FileBytes(const FileBytes&) = delete;
  FileBytes& operator=(const FileBytes&) = delete;

  std::string_view text() const { return {data_, size_}; }

 private:
  const char* data_ = nullptr;
  std::size_t size_ = 0;
};

// SHA-256 in lower-case hexadecimal digits.
std::string Sha256(std::string_view bytes);

// The same of bytes that come in parts.
class Sha256Sum {
 public:
  Sha256Sum();
  ~Sha256Sum();
  Sha256Sum(const Sha256Sum&) = delete;
  Sha256Sum& operator=(const Sha256Sum&) = delete;

  void Add(std::string_view bytes);
  std::string Text();  // once, at the end

 private:
  evp_md_ctx_st* context_;
};

}  // namespace brachium
