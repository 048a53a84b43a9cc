// Results reach the disk whole or not at all: written aside, then renamed into place.
#pragma once

#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace brachium {

// A result could not be written.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// There is a result already, and nobody said that it may be replaced.
class OutputExists : public OutputError {
 public:
  using OutputError::OutputError;
};

// A file being written; on the disk for good after Close(). Throws OutputError.
class OutputFile {
 public:
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void Append(std::string_view bytes);
  void Close();

 private:
  std::string path_;
  int fd_;
};

// Puts a file in its place in one step; its folder is made if need be. The same bytes again are no
// overwrite. Throws OutputExists and OutputError.
void WriteOneFile(const std::string& path, std::string_view text, bool overwrite);

// What a kind of folder holds besides its results proper.
struct FolderKind {
  std::string what;             // "an estimate", for messages
  std::string marker;           // the file by which an older result is recognised: "summary.json"
  std::set<std::string> fresh;  // files that may differ between two runs of the same thing
  std::set<std::string> stale;  // files beside it that a new result makes void
};

// Throws OutputExists when `folder` holds something that a result may not replace: anything, unless
// `overwrite`; with it, whatever is not a result of that kind. For a check before long work.
void CheckReplaceable(const std::string& folder, const FolderKind& kind, bool overwrite);

// A folder in the making, beside its final place. Files of an older result that the new one does
// not write are kept. Without Commit() nothing remains.
class OutputFolder {
 public:
  OutputFolder(const std::string& folder, FolderKind kind, bool overwrite);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  // The path of a file to be written by the caller.
  std::string File(const std::string& name) const { return draft_ + "/" + name; }
  void Write(const std::string& name, std::string_view text) const;

  const std::string& draft() const { return draft_; }

  // Puts the folder in its place in one step. The same bytes again are no overwrite: the old folder
  // then stays. Throws OutputExists and OutputError.
  void Commit();

 private:
  bool SaysTheSame() const;
  void KeepOtherFiles() const;

  std::string folder_;
  std::string draft_;
  FolderKind kind_;
  bool overwrite_;
};

}  // namespace brachium
