// Lists in one flag.
#pragma once

#include <string>
#include <vector>

namespace brachium {

// The parts between commas, without the empty ones.
std::vector<std::string> SplitList(const std::string& list);

struct NamedFolder {
  std::string name;  // differs from folder to folder, fit for a file's name
  std::string path;
};

// The trial folders that a comma-separated list of folders and patterns ("trials/rig_*") stands
// for, each once, the matches of a pattern in alphabetical order. A pattern matches folders with a
// trial.json; a folder without wildcards is taken as it is. A folder is called by the last part of
// its path, with those before it where that is not enough. Throws InputError for a pattern that
// matches nothing.
std::vector<NamedFolder> TrialFolders(const std::string& list);

}  // namespace brachium
