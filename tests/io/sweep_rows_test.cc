#include "io/sweep_rows.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/temporary_folder.h"

namespace brachium {
namespace {

SweepTask TaskWith(std::size_t index, const std::string& trial, const std::string& method,
                   const nlohmann::ordered_json& varied) {
  return {.index = index, .trial = trial, .method = method, .varied = varied};
}

TEST(SweepRows, AreFilledUpToTheColumnsThatLaterOnesBring) {
  const TemporaryFolder folder;
  SweepRows rows(folder.path());
  rows.Append(TaskWith(0, "one", "luinge", {{"a", 1.5}}), std::nullopt);
  rows.Append(TaskWith(1, "one", "luinge", {{"a", 2.0}}),
              SweepResult{.figures = {{"x", 0.5}, {"y", 3.0}}});
  rows.Append(TaskWith(2, "two", "smoother", {{"b", true}, {"c", "chain"}}),
              SweepResult{.trusted = false, .reason = "slow", .figures = {{"z", 7.0}, {"x", 1.0}}});
  EXPECT_EQ(rows.figures(), (std::vector<std::string>{"x", "y", "z"}));
  StreamedFile csv(folder.File("sweep.csv"));
  rows.WriteTo(&csv);
  csv.Commit(false, "");
  EXPECT_EQ(folder.Read("sweep.csv"),
            "task,trial,method,a,b,c,outcome,trusted,reason,x,y,z\n"
            "0,one,luinge,1.5,,,missing,,,,,\n"
            "1,one,luinge,2.0,,,done,1,,0.5,3,\n"
            "2,two,smoother,,true,chain,done,0,slow,1,,7\n");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(SweepRows, QuoteWhatACellCannotHold) {
  const TemporaryFolder folder;
  SweepRows rows(folder.path());
  rows.Append(TaskWith(0, "a,\"b\"\n", "zhou", {}),
              SweepResult{.outcome = SweepResult::Outcome::kFailed, .reason = "no, never"});
  StreamedFile csv(folder.File("sweep.csv"));
  rows.WriteTo(&csv);
  csv.Commit(false, "");
  EXPECT_EQ(folder.Read("sweep.csv"),
            "task,trial,method,outcome,trusted,reason\n0,\"a,\"\"b\"\"\n\",zhou,failed,,\"no, "
            "never\"\n");
}

TEST(SweepRows, SayWhenNothingCanBePutAside) {
  EXPECT_THROW(SweepRows("/nowhere/at/all"), OutputError);
}

}  // namespace
}  // namespace brachium
