#include "io/output_folder.h"

#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "io/file_bytes.h"

namespace brachium {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void FailWriting(const std::string& path) {
  throw OutputError(path + ": cannot be written (" + std::strerror(errno) + ")");
}

void SyncFolder(const std::string& folder) {
  const int fd = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd < 0) return;
  fsync(fd);
  close(fd);
}

// The folder that a path names, links followed, without a slash at its end.
std::string Resolved(const std::string& folder) {
  if (folder.empty()) throw OutputError("the output folder has no name");
  std::error_code error;
  fs::path path = fs::weakly_canonical(fs::absolute(folder), error);
  if (error) throw OutputError(folder + ": cannot be written (" + error.message() + ")");
  if (!path.has_filename()) path = path.parent_path();
  return path.string();
}

std::string DraftBeside(const std::string& folder) {
  const fs::path path(folder);
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  std::string name(".");
  name.append(path.filename().string()).append(".partial.").append(std::to_string(getpid()));
  const std::string draft = (path.parent_path() / name).string();
  fs::remove_all(draft, error);
  if (!fs::create_directory(draft, error))
    throw OutputError(folder + ": cannot be written (" + error.message() + ")");
  return draft;
}

void Move(const std::string& from, const std::string& to) {
  if (std::rename(from.c_str(), to.c_str()) != 0) FailWriting(to);
}

// Swaps two folders in one step; where the file system cannot (NFS), in two.
void Exchange(const std::string& a, const std::string& b) {
  if (renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0) return;
  if (errno != EINVAL && errno != ENOSYS) FailWriting(b);
  const std::string aside = a + ".old";
  Move(b, aside);
  Move(a, b);
  Move(aside, a);
}

bool HoldsFolders(const std::string& folder) {
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_directory()) return true;
  return false;
}

// Puts the text in its place in one step.
void WriteAside(const fs::path& path, std::string_view text) {
  const fs::path draft = path.string() + ".partial." + std::to_string(getpid());
  try {
    OutputFile file(draft.string());
    file.Append(text);
    file.Close();
    if (std::rename(draft.c_str(), path.c_str()) != 0)
      throw OutputError(path.string() + ": cannot be written (" + std::strerror(errno) + ")");
  } catch (const OutputError&) {
    std::error_code ignored;
    fs::remove(draft, ignored);
    throw;
  }
}

}  // namespace

OutputFile::OutputFile(const std::string& path)
    : path_(path), fd_(open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)) {
  if (fd_ < 0) FailWriting(path_);
}

OutputFile::~OutputFile() {
  if (fd_ >= 0) close(fd_);
}

void OutputFile::Append(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(fd_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) FailWriting(path_);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void OutputFile::Close() {
  if (fsync(fd_) != 0) FailWriting(path_);
  if (close(std::exchange(fd_, -1)) != 0) FailWriting(path_);
}

void WriteOneFile(const std::string& path, std::string_view text, bool overwrite) {
  std::error_code error;
  if (fs::exists(path, error)) {
    if (fs::is_regular_file(path) && FileBytes(path).text() == text) return;
    if (!overwrite) throw OutputExists(path + ": exists; choose another place, or say --overwrite");
  }
  const fs::path folder = fs::path(path).parent_path();
  if (!folder.empty()) fs::create_directories(folder, error);
  if (error) throw OutputError(folder.string() + ": cannot be written (" + error.message() + ")");
  WriteAside(path, text);
}

void CheckReplaceable(const std::string& folder, const FolderKind& kind, bool overwrite) {
  if (!fs::exists(folder)) return;
  if (!fs::is_directory(folder))
    throw OutputExists(folder + ": is a file; expected a folder to be made for " + kind.what);
  if (fs::is_empty(folder)) return;
  if (!overwrite)
    throw OutputExists(folder + ": exists; choose another folder, or say --overwrite");
  if (!fs::exists(fs::path(folder) / kind.marker) || HoldsFolders(folder))
    throw OutputExists(folder + ": is not " + kind.what + ", so it is not overwritten");
}

OutputFolder::OutputFolder(const std::string& folder, FolderKind kind, bool overwrite)
    : folder_(Resolved(folder)),
      draft_(DraftBeside(folder_)),
      kind_(std::move(kind)),
      overwrite_(overwrite) {}

OutputFolder::~OutputFolder() {
  std::error_code error;
  fs::remove_all(draft_, error);
}

void OutputFolder::Write(const std::string& name, std::string_view text) const {
  OutputFile file(File(name));
  file.Append(text);
  file.Close();
}

bool OutputFolder::SaysTheSame() const {
  if (!fs::is_directory(folder_)) return false;
  for (const auto& entry : fs::directory_iterator(draft_)) {
    const std::string name = entry.path().filename().string();
    if (kind_.fresh.contains(name)) continue;
    if (!fs::is_regular_file(fs::path(folder_) / name)) return false;
    if (FileBytes(entry.path().string()).text() != FileBytes(folder_ + "/" + name).text())
      return false;
  }
  return true;
}

void OutputFolder::KeepOtherFiles() const {
  for (const auto& entry : fs::directory_iterator(folder_)) {
    const std::string name = entry.path().filename().string();
    if (!fs::exists(File(name)) && !kind_.stale.contains(name))
      fs::create_hard_link(entry.path(), File(name));
  }
}

void OutputFolder::Commit() try {
  if (!overwrite_ && SaysTheSame()) return;
  CheckReplaceable(folder_, kind_, overwrite_);
  const bool replaces = fs::is_directory(folder_) && !fs::is_empty(folder_);
  if (replaces) KeepOtherFiles();
  SyncFolder(draft_);
  if (replaces)
    Exchange(draft_, folder_);
  else
    Move(draft_, folder_);
  SyncFolder(fs::path(folder_).parent_path().string());
} catch (const fs::filesystem_error& error) {
  throw OutputError(folder_ + ": cannot be written (" + error.code().message() + ")");
}

}  // namespace brachium
