#include "bin/lists.h"

#include <glob.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "io/input_error.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> Matches(const std::string& pattern) {
  glob_t found{};
  std::vector<std::string> folders;
  if (glob(pattern.c_str(), GLOB_TILDE, nullptr, &found) == 0)
    for (std::size_t i = 0; i < found.gl_pathc; ++i)
      if (fs::exists(fs::path(found.gl_pathv[i]) / "trial.json"))
        folders.emplace_back(found.gl_pathv[i]);
  globfree(&found);
  std::sort(folders.begin(), folders.end());
  if (folders.empty()) throw InputError(pattern, 0, "matches no folder with a trial.json");
  return folders;
}

fs::path Absolute(const std::string& folder) {
  std::error_code ignored;
  fs::path path = fs::weakly_canonical(fs::absolute(folder), ignored);
  return path.has_filename() ? path : path.parent_path();
}

// The last parts of a path.
std::string Ending(const fs::path& path, int parts) {
  std::string name = path.filename().string();
  for (fs::path parent = path.parent_path(); --parts > 0 && parent.has_filename();
       parent = parent.parent_path())
    name = parent.filename().string() + "-" + name;
  return name;
}

std::string NameAmong(const fs::path& path, const std::vector<fs::path>& all) {
  const auto longest = std::distance(path.begin(), path.end());
  for (int parts = 1; parts < longest; ++parts) {
    const std::string name = Ending(path, parts);
    const auto same = std::count_if(all.begin(), all.end(), [&](const fs::path& other) {
      return Ending(other, parts) == name;
    });
    if (same == 1) return name;
  }
  return Ending(path, static_cast<int>(longest));
}

}  // namespace

std::vector<std::string> SplitList(const std::string& list) {
  std::vector<std::string> parts;
  std::size_t start = 0;
  while (start <= list.size()) {
    const std::size_t end = std::min(list.find(',', start), list.size());
    if (end > start) parts.push_back(list.substr(start, end - start));
    start = end + 1;
  }
  return parts;
}

std::vector<NamedFolder> TrialFolders(const std::string& list) {
  std::vector<std::string> folders;
  std::vector<fs::path> paths;
  for (const std::string& item : SplitList(list)) {
    const bool pattern = item.find_first_of("*?[") != std::string::npos;
    for (const std::string& folder : pattern ? Matches(item) : std::vector<std::string>{item}) {
      const fs::path path = Absolute(folder);
      if (std::find(paths.begin(), paths.end(), path) != paths.end()) continue;
      folders.push_back(folder);
      paths.push_back(path);
    }
  }
  std::vector<NamedFolder> named;
  for (std::size_t i = 0; i < folders.size(); ++i)
    named.push_back({.name = NameAmong(paths[i], paths), .path = folders[i]});
  return named;
}

}  // namespace brachium
