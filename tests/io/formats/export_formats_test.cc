// The other makers' formats, and what holds for all of them.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/io/formats/export_fixture.h"
#include "tests/support/temporary_folder.h"

namespace brachium {
namespace {

using testing::HasSubstr;

std::string TextOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// A Motion-BIDS recording is three files.
class Bids : public testing::Test {
 protected:
  void SetUp() override {
    disk_.Write("sub_motion.tsv", BidsText());
    disk_.Write("sub_channels.tsv", BidsChannels());
    disk_.Write("sub_motion.json", R"({"SamplingFrequency": 50})");
  }
  std::string Path() const { return disk_.File("sub_motion.tsv"); }

  TemporaryFolder disk_;
};

TEST(XsensDot, IsReadInRadiansAcrossTheWrapOfItsClock) {
  const RecordingFile file = ReadText("xsens_dot", DotText(), "Wrist_20260101_100000_000.csv");
  EXPECT_EQ(file.recording.size(), 200u);
  EXPECT_NEAR(file.facts.rate_hz, 60.0, 0.01);
  ExpectTheTurn(file.recording, 0.0, 1e-4);
}

TEST(XsensDot, WithoutARateOfTurnIsRefusedWithTheRemedy) {
  const std::string fusion = DotText("FreeAcc_X,FreeAcc_Y,FreeAcc_Z,Quat_W,Quat_X,Quat_Y");
  EXPECT_THAT(Refusal("xsens_dot", fusion), HasSubstr("expected a measurement mode"));
}

TEST(XsensDot, WarnsOfASensorThatWasNotSynchronised) {
  std::string text = DotText();
  text.replace(text.find("Synced"), 6, "Unsynced");
  Findings findings;
  ReadText("xsens_dot", text, "a.csv", "", {}, &findings);
  EXPECT_THAT(findings.warnings, testing::Contains(HasSubstr("[clock]")));
}

TEST(Apdm, IsReadInBothLayoutsAndInTheUnitsThatItNames) {
  for (const std::string sensor : {"Wrist", "Upper"})
    ExpectTheTurn(ReadText("apdm", ApdmOldText(), "a.csv", sensor).recording, 0.0);
  const RecordingFile file = ReadText("apdm", ApdmNewText(), "a.csv", "Right Wrist");
  EXPECT_NEAR(file.facts.rate_hz, 128.0, 0.01);
  ExpectTheTurn(file.recording, 0.0, 1e-4);
}

TEST(Apdm, AsksWhichOfItsSensorsIsMeant) {
  EXPECT_THAT(Refusal("apdm", ApdmOldText(), "a.csv"), HasSubstr("Wrist, Upper"));
  EXPECT_THAT(Refusal("apdm", "Test,1\nother,2\n"), HasSubstr("expected Format=7"));
  std::string text = ApdmOldText();
  text.replace(text.find(",deg/s"), 6, ",turns");
  EXPECT_THAT(Refusal("apdm", text, "a.csv", "Wrist"), HasSubstr("unit 'turns' is not known"));
}

TEST(Xio, IsReadInTheUnitsOfItsHeaderAtIrregularTimes) {
  ExpectTheTurn(ReadText("xio", XioText(), "a.csv").recording, 0.0);
  std::string text = XioText();
  text.replace(text.find("(g)"), 3, "(G)");
  EXPECT_THAT(Refusal("xio", text, "a.csv"), HasSubstr("names two units"));
}

TEST_F(Bids, IsReadWithChannelsAndRateFromTheFilesBesideIt) {
  const RecordingFile file = ReadText("motion_bids", BidsText(), Path());
  EXPECT_NEAR(file.facts.rate_hz, 50.0, 1e-9);
  EXPECT_EQ(file.facts.not_finite_rows, 1u);
  ExpectTheTurn(file.recording, 0.0);
}

TEST_F(Bids, OfMarkersIsRefused) {
  disk_.Write("sub_channels.tsv",
              "name\tcomponent\ttype\ttracked_point\tunits\na\tx\tPOS\thead\tmm\n");
  EXPECT_THAT(Refusal("motion_bids", BidsText(), Path()), HasSubstr("not markers"));
}

// Bytes changed, taken out or doubled anywhere: read, or refused as a wrong file; nothing else.
std::string Damaged(std::string text) {
  const auto wounds = *rc::gen::inRange(1, 5);
  for (int i = 0; i < wounds && !text.empty(); ++i) {
    const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
    const auto length = std::min(*rc::gen::inRange<std::size_t>(1, 30), text.size() - at);
    switch (*rc::gen::inRange(0, 4)) {
      case 0:
        text[at] = *rc::gen::arbitrary<char>();
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, text.substr(at, length));
        break;
      default:
        text.insert(at, *rc::gen::elementOf(std::vector<std::string>{
                            "\n", ",", "\t", "nan", "1e308", "-", "//", ":", "65535", "\r", "g"}));
    }
  }
  return text;
}

void ReadOrRefuse(const std::string& format, const std::string& text, const std::string& path,
                  const std::string& sensor) {
  try {
    ReadText(format, Damaged(text.substr(0, 2500)), path, sensor);
  } catch (const InputError& error) {
    RC_ASSERT(std::string(error.what()).find(": ") != std::string::npos);
  }
}

RC_GTEST_PROP(ExportFuzz, DamagedXsensMtIsReadOrRefused, ()) {
  ReadOrRefuse("xsens_mt", MtText(), "a.txt", "");
}
RC_GTEST_PROP(ExportFuzz, DamagedDotIsReadOrRefused, ()) {
  ReadOrRefuse("xsens_dot", DotText(), "a.csv", "");
}
RC_GTEST_PROP(ExportFuzz, DamagedApdmIsReadOrRefused, ()) {
  ReadOrRefuse("apdm", ApdmOldText(), "a.csv", "Wrist");
  ReadOrRefuse("apdm", ApdmNewText(), "a.csv", "Left Wrist");
}
RC_GTEST_PROP(ExportFuzz, DamagedXioIsReadOrRefused, ()) {
  ReadOrRefuse("xio", XioText(), "a.csv", "");
}
RC_GTEST_FIXTURE_PROP(Bids, DamagedInAnyOfItsFilesIsReadOrRefused, ()) {
  const auto which = *rc::gen::inRange(0, 3);
  disk_.Write("sub_channels.tsv", which == 0 ? Damaged(BidsChannels()) : BidsChannels());
  const std::string json = R"({"SamplingFrequency": 50})";
  disk_.Write("sub_motion.json", which == 1 ? Damaged(json) : json);
  ReadOrRefuse("motion_bids", BidsText(), Path(), "");
}

double MedianNorm(const std::vector<Eigen::Vector3d>& vectors) {
  std::vector<double> norms;
  for (const Eigen::Vector3d& v : vectors) norms.push_back(v.norm());
  std::ranges::sort(norms);
  return norms[norms.size() / 2];
}

class ExportSamples : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::is_directory(kSamples)) GTEST_SKIP() << "no samples at hand";
  }
  static RecordingFile Read(const std::string& format, const std::string& name,
                            const std::string& sensor = "") {
    const auto path = kSamples / name;
    return ReadText(format, TextOf(path), path.string(), sensor);
  }
};

TEST_F(ExportSamples, OfDotHaveDegreesWrapsAndLosses) {
  const RecordingFile file =
      Read("xsens_dot", "xsens_dot_csv/SYNTHETIC_dot_recording_rate_quantities.csv");
  EXPECT_NEAR(file.facts.rate_hz, 60.0, 0.01);
  EXPECT_EQ(file.facts.lost_samples, 2u);
  EXPECT_NEAR(file.recording.gyr_S[0].x(), M_PI / 2.0, 1e-6);
  EXPECT_NEAR(file.recording.acc_S[0].norm(), 9.81, 0.01);
  EXPECT_THROW(Read("xsens_dot", "xsens_dot_csv/LFemur_20210820_202113_831.csv"), InputError);
  EXPECT_THROW(Read("xsens_dot", "xsens_dot_csv/Pelvis_20210820_202113_836.csv"), InputError);
}

TEST_F(ExportSamples, OfApdmHaveGravityRateAndSmallRates) {
  const RecordingFile file = Read("apdm", "apdm/imuData01.csv", "Static");
  EXPECT_NEAR(file.facts.rate_hz, 128.0, 0.1);
  EXPECT_NEAR(MedianNorm(file.recording.acc_S), 9.8, 0.05);
  EXPECT_LT(MedianNorm(file.recording.gyr_S), 0.02);
  const RecordingFile seven = Read("apdm", "apdm/apdm_format7.csv", "Right Ankle");
  EXPECT_NEAR(seven.facts.rate_hz, 128.0, 0.1);
  EXPECT_NEAR(seven.recording.acc_S[1].norm(), 9.99, 0.5);
}

TEST_F(ExportSamples, OfXioHaveGravityInMetresAndStillRates) {
  const RecordingFile file = Read("xio", "xio_csv/fusion_sensor_data_first500.csv");
  EXPECT_NEAR(file.facts.rate_hz, 100.0, 2.0);
  for (const auto& f_S : file.recording.acc_S) EXPECT_NEAR(f_S.norm(), 9.75, 0.3);
  for (const auto& omega_S : file.recording.gyr_S) EXPECT_LT(omega_S.norm(), 0.02);
}

TEST_F(ExportSamples, OfMotionBidsAreReadByTheirChannelsOrRefusedAsMarkers) {
  EXPECT_THROW(Read("motion_bids", "motion_bids/sub-01_task-pullstand_tracksys-mocap_motion.tsv"),
               InputError);
  const auto folder = kSamples / "motion_bids/motion_systemvalidation/sub-pp002/motion";
  const std::string stem = "sub-pp002_task-backwards_tracksys-imu";
  TemporaryFolder disk;
  disk.Write("x_channels.tsv", TextOf(folder / (stem + "_channels.tsv")));
  disk.Write("x_motion.json", TextOf(folder / (stem + "_motion.json")));
  std::string row;
  for (int sensor = 0; sensor < 16; ++sensor) row += "0\t0\t9.81\t";
  for (int number = 0; number < 96; ++number) row += "0\t";
  row.back() = '\n';
  const RecordingFile file =
      ReadText("motion_bids", row + row + row, disk.File("x_motion.tsv"), "rightForeArm");
  EXPECT_NEAR(file.facts.rate_hz, 199.906, 0.01);
  EXPECT_DOUBLE_EQ(file.recording.acc_S[0].norm(), 9.81);
}

}  // namespace
}  // namespace brachium
