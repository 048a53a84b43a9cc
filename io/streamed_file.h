// A long text file, written piece by piece and put in its place in one step.
#pragma once

#include <string>
#include <string_view>

#include "io/output_folder.h"

namespace brachium {

class StreamedFile {
 public:
  // The file's folder is made if need be. Throws OutputError.
  explicit StreamedFile(const std::string& path);
  ~StreamedFile();  // without Commit() nothing remains
  StreamedFile(const StreamedFile&) = delete;
  StreamedFile& operator=(const StreamedFile&) = delete;

  void Append(std::string_view text);

  // The same bytes again are no overwrite. Throws OutputExists, saying `why`, and OutputError.
  void Commit(bool overwrite, const std::string& why);

 private:
  void Flush();

  std::string path_, draft_, buffer_;
  OutputFile file_;
};

}  // namespace brachium
