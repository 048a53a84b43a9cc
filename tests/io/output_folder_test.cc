#include "io/output_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/temporary_folder.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;

const FolderKind kKind{
    .what = "a result", .marker = "main.txt", .fresh = {"time.txt"}, .stale = {"old.txt"}};

void Make(const std::string& folder, const std::string& text, bool overwrite = false,
          const std::string& time = "now") {
  OutputFolder output(folder, kKind, overwrite);
  output.Write("main.txt", text);
  output.Write("time.txt", time);
  output.Commit();
}

std::size_t EntriesIn(const std::string& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

TEST(OutputFolder, AppearsWholeAndLeavesNothingBeside) {
  const TemporaryFolder here;
  Make(here.File("deeper/result"), "one");
  EXPECT_EQ(here.Read("deeper/result/main.txt"), "one");
  EXPECT_EQ(EntriesIn(here.File("deeper")), 1u);
}

TEST(OutputFolder, LeavesNothingWithoutCommit) {
  const TemporaryFolder here;
  {
    const OutputFolder output(here.File("result"), kKind, false);
    output.Write("main.txt", "one");
  }
  EXPECT_EQ(EntriesIn(here.path()), 0u);
}

TEST(OutputFolder, FillsAnEmptyFolderAndTakesASlashAtTheEnd) {
  const TemporaryFolder here;
  fs::create_directory(here.File("result"));
  Make(here.File("result") + "/", "one");
  EXPECT_EQ(here.Read("result/main.txt"), "one");
}

TEST(OutputFolder, RefusesToOverwriteAndKeepsTheOldResult) {
  const TemporaryFolder here;
  Make(here.File("result"), "one");
  EXPECT_THROW(Make(here.File("result"), "two"), OutputExists);
  EXPECT_EQ(here.Read("result/main.txt"), "one");
  EXPECT_EQ(EntriesIn(here.path()), 1u);
}

TEST(OutputFolder, TakesTheSameBytesForNoOverwrite) {
  const TemporaryFolder here;
  Make(here.File("result"), "one", false, "monday");
  EXPECT_NO_THROW(Make(here.File("result"), "one", false, "tuesday"));
  EXPECT_EQ(here.Read("result/time.txt"), "monday");
}

TEST(OutputFolder, ReplacesTheOldResultWhenTold) {
  const TemporaryFolder here;
  Make(here.File("result"), "one");
  here.Write("result/notes.txt", "mine");
  here.Write("result/old.txt", "void");
  Make(here.File("result"), "two", true);
  EXPECT_EQ(here.Read("result/main.txt"), "two");
  EXPECT_EQ(here.Read("result/notes.txt"), "mine");
  EXPECT_FALSE(here.Has("result/old.txt"));
  EXPECT_EQ(EntriesIn(here.path()), 1u);
}

TEST(OutputFolder, NeverReplacesAFolderOfAnotherKind) {
  const TemporaryFolder here;
  fs::create_directory(here.File("result"));
  here.Write("result/thesis.txt", "mine");
  EXPECT_THROW(Make(here.File("result"), "one", true), OutputExists);
  EXPECT_EQ(here.Read("result/thesis.txt"), "mine");

  Make(here.File("other"), "one");
  fs::create_directory(here.File("other/below"));
  EXPECT_THROW(Make(here.File("other"), "two", true), OutputExists);
}

TEST(OutputFolder, NeverReplacesAFile) {
  const TemporaryFolder here;
  here.Write("result", "mine");
  EXPECT_THROW(Make(here.File("result"), "one", true), OutputExists);
  EXPECT_EQ(here.Read("result"), "mine");
}

TEST(OutputFolder, SaysWhenItCannotWrite) {
  EXPECT_THROW(Make("/proc/nowhere/result", "one"), OutputError);
  EXPECT_THROW(Make("", "one"), OutputError);
}

}  // namespace
}  // namespace brachium
