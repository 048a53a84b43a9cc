#include "io/formats/export_table.h"
#include "tests/io/formats/export_fixture.h"
#include "tests/support/temporary_folder.h"

namespace brachium {
namespace {

using testing::HasSubstr;

TEST(XsensMt, IsReadInAllFourDelimitersWithTimesAtTheCentreOfEachSample) {
  for (const char delimiter : {'\t', ',', ';', ' '}) {
    const RecordingFile file = ReadText("xsens_mt", MtText({.delimiter = delimiter}));
    EXPECT_EQ(file.recording.size(), 200u);
    EXPECT_DOUBLE_EQ(file.recording.time.front(), -0.005);
    ExpectTheTurn(file.recording, 0.0);
  }
}

TEST(XsensMt, SaysThatTimesWereMoved) {
  Findings findings;
  ReadText("xsens_mt", MtText(), "a.txt", "", {}, &findings);
  EXPECT_THAT(findings.defaults, testing::Contains(HasSubstr("half a sample, 5.000 ms")));
}

TEST(XsensMt, FollowsACounterThatWrapsAndCountsLostPackets) {
  const RecordingFile file = ReadText("xsens_mt", MtText({.first = 65500, .lost_after = 90}));
  ExpectTheTurn(file.recording, 0.0);
  EXPECT_EQ(file.facts.gaps, 1u);
  EXPECT_EQ(file.facts.lost_samples, 3u);
}

TEST(XsensMt, PlacesASensorThatStartsLaterByItsCounterAcrossTheWrap) {
  ExportClock clock;
  Findings findings;
  const auto read = [&](const std::string& text) {
    return ReadXsensMt({.path = "x.txt", .name = "x.txt", .text = text}, &clock, &findings);
  };
  read(MtText({.first = 65530}));
  EXPECT_NEAR(read(MtText({.first = 4}))[0].table.Column("time_s")[0], 0.1 - 0.005, 1e-12);
  EXPECT_NEAR(read(MtText({.first = 65520}))[0].table.Column("time_s")[0], -0.1 - 0.005, 1e-12);
}

TEST(XsensMt, HasNoDefaultRate) {
  const MtOptions silent{.header = "// General information:\n//  DeviceId: 00B42D4B\n"};
  EXPECT_THAT(Refusal("xsens_mt", MtText(silent)), HasSubstr("expected the rate to be told"));
  const RecordingFile told =
      ReadText("xsens_mt", MtText(silent), "a.txt", "", {.rate_hz = 100.0, .origin = {}});
  ExpectTheTurn(told.recording, 0.0);
}

TEST(XsensMt, TakesTheRateFromAFilledSampleTimeFine) {
  std::string text = "PacketCounter,SampleTimeFine,Acc_X,Acc_Y,Acc_Z,Gyr_X,Gyr_Y,Gyr_Z\n";
  for (int i = 0; i < 10; ++i)
    text += std::to_string(i) + "," + std::to_string(7000 + 250 * i) + ",0,0,9.81,0,0,0\n";
  EXPECT_NEAR(ReadText("xsens_mt", text).facts.rate_hz, 40.0, 1e-9);
}

TEST(XsensMt, WarnsOfARateThatContradictsTheFile) {
  Findings findings;
  ReadText("xsens_mt", MtText(), "a.txt", "", {.rate_hz = 60.0, .origin = {}}, &findings);
  EXPECT_THAT(findings.warnings, testing::Contains(HasSubstr("the file says 100.0 Hz")));
}

TEST(XsensMt, LeavesOutRowsWithMissingNumbersAndReadsTheAliasOfTheCounter) {
  std::string text = MtText({.header = ""});
  text.replace(0, std::string("PacketCounter").size(), "Counter");
  text += "300\t\tNaN\t0\t9.81\t0\t0\t0\n301\t\t\t0\t9.81\t0\t0\t0\t\n";
  const RecordingFile file =
      ReadText("xsens_mt", text, "a.txt", "", {.rate_hz = 100.0, .origin = {}});
  EXPECT_EQ(file.recording.size(), 200u);
  EXPECT_EQ(file.facts.not_finite_rows, 2u);
}

TEST(XsensMt, RefusesWhatIsNotOfIt) {
  EXPECT_THAT(Refusal("xsens_mt", "// Update Rate: 100.0Hz\nPacketCounter\tAcc_X\n1\t2\n"),
              HasSubstr(":2: has no Gyr_X"));
  EXPECT_THAT(Refusal("xsens_mt", ""), HasSubstr("is empty"));
  EXPECT_THAT(Refusal("xsens_mt", "// only a comment\n"), HasSubstr("no column names"));
  EXPECT_THAT(Refusal("xsens_mt", MtText() + "301\t\t0\t0\tabc\t0\t0\t0\n"),
              HasSubstr("Acc_Z is 'abc'"));
  std::string commas = MtText({.delimiter = ';'});
  std::ranges::replace(commas, '.', ',');
  EXPECT_THAT(Refusal("xsens_mt", commas), HasSubstr("[decimal_comma]"));
}

TEST(XsensMt, TurnsANorthEastDownOrientationUp) {
  const std::string text =
      "//  DeviceId: 00B42D4B\n// Coordinate system: NED\n// Update Rate: 100Hz\n"
      "PacketCounter,Acc_X,Acc_Y,Acc_Z,Gyr_X,Gyr_Y,Gyr_Z,Quat_q0,Quat_q1,Quat_q2,Quat_q3\n"
      "1,0,0,9.81,0,0,0,0,1,0,0\n2,0,0,9.81,0,0,0,0,1,0,0\n";
  const Recording recording = ReadText("xsens_mt", text).recording;
  EXPECT_NEAR((recording.q_WS[0] * recording.acc_S[0]).z(), 9.81, 1e-9);
}

// The samples: one sensor exported in many ways, and long recordings with losses.
class XsensMtSamples : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::is_directory(kSamples)) GTEST_SKIP() << "no samples at hand";
  }

  static RecordingFile Read(const std::string& name, std::optional<double> rate = {}) {
    const std::string path = (kSamples / "xsens_mt_ascii" / name).string();
    return ReadText("xsens_mt", TextOf(path), path, "", {.rate_hz = rate, .origin = {}});
  }

  static std::string TextOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  static double MedianForce(const Recording& recording) {
    std::vector<double> norms;
    for (const auto& f_S : recording.acc_S) norms.push_back(f_S.norm());
    std::ranges::sort(norms);
    return norms[norms.size() / 2];
  }
};

TEST_F(XsensMtSamples, SayTheSameInEveryDelimiterAndKeepOrientationUpright) {
  for (const std::string name : {"MT2022_ACC_GYRO_ROT_MAT_COMMA_00B42D4B.txt",
                                 "MT2022_ACC_GYRO_ROT_MAT_SEMICOLON_00B42D4B.txt",
                                 "MT2022_ACC_GYRO_ROT_MAT_SPACE_00B42D4B.txt",
                                 "MT2022_ACC_GYRO_ROT_EULER_TAB_00B42D4F.txt"}) {
    const Recording recording = Read(name, 100.0).recording;
    EXPECT_NEAR(MedianForce(recording), 9.93, 0.1) << name;
    ASSERT_FALSE(recording.q_WS.empty()) << name;
    const Eigen::Vector3d f_W = recording.q_WS[0] * recording.acc_S[0];
    EXPECT_GT(f_W.normalized().z(), 0.999) << name;
  }
  EXPECT_THROW(Read("MT2022_ACC_GYRO_ROT_MAT_COMMA_00B42D4B.txt"), InputError);
}

TEST_F(XsensMtSamples, HaveTheirRateGravityAndLosses) {
  const RecordingFile walk = Read("MT_012005D6_031-000_00B421AF.txt");
  EXPECT_NEAR(walk.facts.rate_hz, 100.0, 1e-6);
  EXPECT_NEAR(MedianForce(walk.recording), 9.81, 0.3);
  EXPECT_LT(walk.recording.gyr_S[0].norm(), 0.1);
  EXPECT_TRUE(walk.facts.magnetometer);
  EXPECT_EQ(Read("MT46_01-000_00B42D4D.txt").recording.size(), 5u);
  EXPECT_NEAR(MedianForce(Read("MT46_01-000_00B42D4E.txt").recording), 9.81, 0.1);
}

TEST_F(XsensMtSamples, WithoutAGyroscopeAreRefused) {
  for (const std::string name : {"MT2022_ACC_00B42D4B.txt", "MT_01200312-002-000_00B474BA.txt",
                                 "MT_012005D6-000_sit_to_stand-000_00B421ED.txt"})
    EXPECT_THROW(Read(name, 100.0), InputError) << name;
}

TEST_F(XsensMtSamples, LoseSixtyEightPacketsOfOneTrial) {
  const std::string path =
      (kSamples / "xsens_mt_ascii/MT_012005D6-000_sit_to_stand-000_00B421ED.txt").string();
  const std::string text = TextOf(path);
  Lines lines(text);
  std::string_view header = lines.Next();
  while (header.starts_with("//")) header = lines.Next();
  const CsvTable table =
      ParseRows(lines.rest(), path, {.names = SplitCells(header, '\t'), .delimiter = '\t'});
  const std::vector<double> counts = Unwrapped(table.Column("PacketCounter"), 65536.0);
  EXPECT_EQ(table.rows, 1459u);
  EXPECT_EQ(counts.back() - counts.front() + 1.0 - static_cast<double>(table.rows), 68.0);
}

}  // namespace
}  // namespace brachium
