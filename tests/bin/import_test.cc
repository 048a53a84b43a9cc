#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace brachium {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class Import : public ProgramTest {
 protected:
  // A sensor that rolls under gravity, as MT Manager exports it; a packet is lost.
  void WriteExport(const std::string& file, const std::string& comment) const {
    std::string text = comment + "PacketCounter;Acc_X;Acc_Y;Acc_Z;Gyr_X;Gyr_Y;Gyr_Z\n";
    for (int i = 0; i < 400; ++i) {
      const double t = 0.01 * i, angle = 0.8 * std::sin(2.0 * t);
      if (i != 50)
        text += std::to_string((65400 + i) % 65536) + ";0;" +
                std::to_string(9.81 * std::sin(angle)) + ";" +
                std::to_string(9.81 * std::cos(angle)) + ";" +
                std::to_string(1.6 * std::cos(2.0 * t)) + ";0;0\n";
    }
    Write(file, text);
  }

  Outcome RunImport(const std::vector<std::string>& more) const {
    std::vector<std::string> words = {"import", "--format=xsens_mt", "--files=" + Path(""),
                                      "--side=left", "--output=" + Path("trial")};
    words.insert(words.end(), more.begin(), more.end());
    return Run(words);
  }
};

TEST_F(Import, MakesATrialFolderThatInspectReads) {
  WriteExport("MT_1_00B42D4B.txt", "// Update Rate: 100.0Hz\n");
  WriteExport("MT_1_00B42D4F.txt", "// Update Rate: 100.0Hz\n");
  const Outcome outcome = RunImport({"--map=00B42D4B:upper_arm,00b42d4f:forearm"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("forearm: sensor 00B42D4F"), HasSubstr("1 lost"),
                                 HasSubstr("half a sample")));
  const Outcome inspected = Run({"inspect", "--trial=" + Path("trial")});
  EXPECT_EQ(inspected.exit_code, 0) << inspected.err;
  EXPECT_THAT(inspected.out, AllOf(HasSubstr("left arm"), HasSubstr("1 sample lost")));
}

TEST_F(Import, WithoutARateAsksForItAndTakesIt) {
  WriteExport("MT_1_00B42D4B.txt", "//  DeviceId: 00B42D4B\n");
  const Outcome silent = RunImport({"--map=00B42D4B:forearm"});
  EXPECT_EQ(silent.exit_code, 2);
  EXPECT_THAT(silent.err, HasSubstr("--rate=HZ"));
  EXPECT_EQ(RunImport({"--map=00B42D4B:forearm", "--rate=100"}).exit_code, 0);
}

TEST_F(Import, RefusesSensorsThatAreNotThereAndMapsThatMakeNoSense) {
  WriteExport("MT_1_00B42D4B.txt", "// Update Rate: 100.0Hz\n");
  const Outcome absent = RunImport({"--map=00B40000:forearm"});
  EXPECT_EQ(absent.exit_code, 2);
  EXPECT_THAT(absent.err, HasSubstr("the sensors at hand are 00B42D4B"));
  EXPECT_THAT(absent.err, HasSubstr("in MT_1_00B42D4B.txt"));
  EXPECT_EQ(RunImport({"--map=00B42D4B:knee"}).exit_code, 1);
  EXPECT_EQ(RunImport({"--map="}).exit_code, 1);
}

TEST_F(Import, KnowsASensorByTheBeginningOfItsFileInWholeWords) {
  WriteExport("MT_01-000_00B42D4B.txt", "// Update Rate: 100.0Hz\n");
  for (const char* key : {"MT_01", "mt_01-", "MT_01-000_00B42D4B"})
    EXPECT_EQ(RunImport({std::string("--map=") + key + ":forearm", "--overwrite"}).exit_code, 0)
        << key;
  for (const char* key : {"MT_0", "01", "M"})
    EXPECT_EQ(RunImport({std::string("--map=") + key + ":forearm", "--overwrite"}).exit_code, 2)
        << key;
}

TEST_F(Import, SaysThatAFolderHoldsNoExport) {
  const Outcome outcome = RunImport({"--map=A:forearm"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("expected the exports of a trial"));
}

// A folder of many recordings as MT Manager left it.
TEST_F(Import, LeadsFromRecordedExportsToAnEstimate) {
  const std::string exports = BRACHIUM_SOURCE_DIR "/../shared/data/formats/xsens_mt_ascii";
  if (!std::filesystem::exists(exports)) GTEST_SKIP() << exports << " is not there";
  const auto import = [&](const std::string& map, const std::string& name) {
    return Run({"import", "--format=xsens_mt", "--files=" + exports, "--map=" + map, "--side=right",
                "--output=" + Path(name)});
  };
  const std::string upper = "MT_012005D6_031-000_00B421AF:upper_arm";
  const std::string fore = "MT_012005D6_031-000_00B4227B:forearm";
  ASSERT_EQ(import(fore, "one").exit_code, 0);
  const Outcome alone = Reconstruct(Path("one"), Path("estimate"));
  EXPECT_EQ(alone.exit_code, 0) << alone.err;
  EXPECT_TRUE(std::filesystem::exists(Path("estimate/estimate.csv")));

  ASSERT_EQ(import(upper + "," + fore, "two").exit_code, 0);
  const Outcome unmounted = Reconstruct(Path("two"), Path("arm"));
  EXPECT_EQ(unmounted.exit_code, 2);
  EXPECT_THAT(unmounted.err, HasSubstr("q_BS_wxyz"));
  auto trial = nlohmann::json::parse(ReadText(Path("two/trial.json")));
  for (auto& recording : trial["recordings"])
    recording["mounting"] = {{"q_BS_wxyz", {0.7071068, 0, 0, -0.7071068}}};
  Write("two/trial.json", trial.dump());
  const Outcome mounted = Reconstruct(Path("two"), Path("arm"));
  EXPECT_EQ(mounted.exit_code, 0) << mounted.err;
}

}  // namespace
}  // namespace brachium
