// What README.md shows, tried.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "tests/support/run_program.h"

namespace brachium {
namespace {

class Guide : public ProgramTest {
 protected:
  const std::string readme_ = ReadText(BRACHIUM_SOURCE_DIR "/README.md");
};

TEST_F(Guide, ItsPythonLoadsAnEstimate) {
  if (std::system("command -v python3 >/dev/null") != 0) GTEST_SKIP() << "python3 is not here";
  const std::string fence = "```python\n";
  const std::size_t start = readme_.find(fence);
  ASSERT_NE(start, readme_.npos);
  const std::size_t end = readme_.find("```", start + fence.size());
  Write("load.py", readme_.substr(start + fence.size(), end - start - fence.size()));
  ASSERT_EQ(Reconstruct(Simulate(), Path("ESTIMATE")).exit_code, 0);

  const std::string command = "cd '" + Path("") + "' && python3 load.py >printed 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << ReadText(Path("printed"));
  EXPECT_THAT(ReadText(Path("printed")),
              testing::ContainsRegex("smoother True 1600 samples\n"
                                     "flexion [0-9.]+ to [0-9.]+ deg, sd [0-9.]+\n"));
}

TEST_F(Guide, TheFilesThatItLinksAreThere) {
  const std::regex link(R"(\]\(([^)#:]+)\))");
  int links = 0;
  for (std::sregex_iterator it(readme_.begin(), readme_.end(), link), end; it != end; ++it, ++links)
    EXPECT_TRUE(std::filesystem::exists(BRACHIUM_SOURCE_DIR "/" + (*it)[1].str())) << (*it)[1];
  EXPECT_GT(links, 10);
}

TEST_F(Guide, TheCommandsThatItShowsAreThere) {
  const std::regex shown("(?:bin/|`|\n)brachium ((?:sweep )?[a-z]+) ");
  int commands = 0;
  for (std::sregex_iterator it(readme_.begin(), readme_.end(), shown), end; it != end;
       ++it, ++commands) {
    std::string command = (*it)[1];
    if (command == "reconstructs") continue;
    std::vector<std::string> words;
    if (command.starts_with("sweep "))
      words = {"sweep", command.substr(6), "--help"};
    else
      words = {command, "--help"};
    EXPECT_EQ(Run(words).exit_code, 0) << command;
  }
  EXPECT_GT(commands, 10);
}

}  // namespace
}  // namespace brachium
