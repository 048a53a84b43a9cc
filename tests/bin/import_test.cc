#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

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
  EXPECT_EQ(RunImport({"--map=00B42D4B:knee"}).exit_code, 1);
  EXPECT_EQ(RunImport({"--map="}).exit_code, 1);
}

}  // namespace
}  // namespace brachium
