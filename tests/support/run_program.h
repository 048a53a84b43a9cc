// The built program, run as a user runs it.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace brachium {

struct Outcome {
  int exit_code = -1;
  std::string out, err;
};

inline std::string ReadText(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// Every file of a folder but `without`: name -> bytes.
inline std::map<std::string, std::string> Bytes(const std::filesystem::path& folder,
                                                const std::string& without = "") {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().filename() != without)
      files[entry.path().filename().string()] = ReadText(entry.path());
  return files;
}

// A test with a folder of its own, in which names have blanks.
class ProgramTest : public testing::Test {
 protected:
  std::string Path(const std::string& name) const { return folder_.File("a folder/" + name); }

  void SetUp() override { std::filesystem::create_directory(folder_.File("a folder")); }

  void Write(const std::string& name, const std::string& text) const {
    std::ofstream(Path(name), std::ios::binary) << text;
  }

  // `before` is a command of the shell, such as one that sets a limit.
  Outcome Run(const std::vector<std::string>& words, const std::string& before = ":") const {
    std::string command = before + "; " + Quoted(BRACHIUM_PROGRAM);
    for (const std::string& word : words) command.append(" ").append(Quoted(word));
    command += " </dev/null >" + Quoted(folder_.File("out")) + " 2>" + Quoted(folder_.File("err"));
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, ReadText(folder_.File("out")),
            ReadText(folder_.File("err"))};
  }

  // What it prints where all is well.
  std::string RunWell(const std::vector<std::string>& words) const {
    const Outcome outcome = Run(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out;
  }

  // A short trial; returns its folder.
  std::string Simulate(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"simulate", "--scenario=reach", "--duration_s=16",
                                      "--output=" + Path("trial")};
    words.insert(words.end(), more.begin(), more.end());
    RunWell(words);
    return Path("trial");
  }

  Outcome Reconstruct(const std::string& trial, const std::string& estimate,
                      const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"reconstruct", "--trial=" + trial, "--output=" + estimate};
    words.insert(words.end(), more.begin(), more.end());
    return Run(words);
  }

 private:
  static std::string Quoted(const std::string& word) {
    std::string quoted = "'";
    for (const char letter : word) quoted += letter == '\'' ? "'\\''" : std::string(1, letter);
    return quoted + "'";
  }

  TemporaryFolder folder_;
};

}  // namespace brachium
