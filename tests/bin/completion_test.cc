// What bash offers behind `brachium`, by the script that the program prints.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tests/support/run_program.h"

namespace brachium {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::StartsWith;

class Completion : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    Write("script", RunWell({"completion"}));
  }

  // What a real bash would offer for the last word of `typed`, split where bash splits it.
  std::vector<std::string> Offered(const std::string& typed) const {
    Write("driver",
          "source \"$1/script\"\n"
          "program() { '" BRACHIUM_PROGRAM
          "' \"$@\"; }\n"
          "COMP_LINE=\"program $2\" COMP_POINT=${#COMP_LINE}\n"
          "read -ra COMP_WORDS <<<\"${COMP_LINE//=/ = }\"\n"
          "COMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n"
          "_brachium\n"
          "printf '%s\\n' \"${COMPREPLY[@]}\" >\"$1/offered\"\n");
    const std::string folder = Path("");
    const std::string command =
        "bash '" + folder + "driver' '" + folder + "' '" + typed + "' 2>'" + folder + "err'";
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_THAT(ReadText(Path("err")), IsEmpty()) << typed;
    std::istringstream offered(ReadText(Path("offered")));
    std::vector<std::string> words;
    for (std::string word; std::getline(offered, word);)
      if (!word.empty()) words.push_back(word);
    return words;
  }
};

TEST_F(Completion, OffersCommands) {
  EXPECT_THAT(Offered("reco"), ElementsAre("reconstruct"));
  EXPECT_THAT(Offered("comp"), ElementsAre("compare", "completion"));
  EXPECT_THAT(Offered(""), AllOf(Contains("evaluate"), Contains("help"), Contains("sweep")));
  EXPECT_THAT(Offered("sweep "), ElementsAre("merge", "plan", "run", "status", "submit"));
  EXPECT_THAT(Offered("sweep s"), ElementsAre("status", "submit"));
}

TEST_F(Completion, OffersTheFlagsOfTheCommand) {
  EXPECT_THAT(Offered("inspect --tr"), ElementsAre("--trial="));
  EXPECT_THAT(Offered("simulate --ov"), ElementsAre("--overwrite"));
  EXPECT_THAT(Offered("sweep run "), AllOf(Contains("--manifest="), Contains("--help")));
  EXPECT_THAT(Offered("evaluate --trial=A --est"), ElementsAre("--estimate="));
}

TEST_F(Completion, OffersTheFlagsOfTheChosenMethod) {
  EXPECT_THAT(Offered("reconstruct --method=luinge --lui"), Contains(StartsWith("--luinge_")));
  EXPECT_THAT(Offered("reconstruct --method=gyroscope --win"), IsEmpty());
  EXPECT_THAT(Offered("reconstruct --method smoother --win"), Contains("--window_s="));
}

TEST_F(Completion, OffersTheNamesThatAFlagTakes) {
  EXPECT_THAT(Offered("reconstruct --method=smo"), ElementsAre("smoother"));
  EXPECT_THAT(Offered("simulate --scenario=daily_"), ElementsAre("daily_brisk", "daily_slow"));
  EXPECT_THAT(Offered("import --format=xs"), ElementsAre("xsens_mt", "xsens_dot"));
  EXPECT_THAT(Offered("compare --methods=smoother,gyr"), ElementsAre("smoother,gyroscope"));
  EXPECT_THAT(Offered("inspect --trial=x"), IsEmpty());
  EXPECT_THAT(Offered("simulate --overwrite=f"), ElementsAre("false"));
}

TEST_F(Completion, OffersNothingBehindWhatIsNoCommand) {
  EXPECT_THAT(Offered("nonsense --"), IsEmpty());
}

}  // namespace
}  // namespace brachium
