#include "io/formats/motion_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "io/input_error.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;

const fs::path kSamples = fs::path(BRACHIUM_SOURCE_DIR) / "../shared/data/formats";

const std::string kSto =
    "DataRate=100.000000\nDataType=Quaternion\nversion=3\nOpenSimVersion=4.4\nendheader\n"
    "time\thumerus_r_imu\tradius_r_imu\n0\t1,0,0,0\t0.6,0.8,0,0\n0.01\t0,1,0,0\t0,0,0,1\n";
const std::string kMot =
    "Coordinates\r\nversion=1\r\nnRows=2\r\ninDegrees=yes\r\n\r\nendheader\r\n"
    "time\telbow_flexion\r\n   0.0\t   12.5\r\n   0.1\t   13.5\r\n";
const std::string kTrc =
    "PathFileType\t4\t(X/Y/Z)\ta.trc\t\nDataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\n"
    "100\t100\t2\t2\tmm\nFrame#\tTime\tC7\t\t\tAC\t\t\n\t\tX1\tY1\tZ1\tX2\tY2\tZ2\n\n"
    "1\t0.00\t1000\t2000\t3000\t\t\t\n2\t0.01\t1\t2\t3\tNan\tNAN\tnan\n";
const std::string kMvnx =
    "<?xml version=\"1.0\"?><mvnx version=\"4\"><subject frameRate=\"60\"><segments>"
    "<segment label=\"RightUpperArm\"/><segment label=\"RightForeArm\"/></segments><joints>"
    "<joint label=\"jRightElbow\"/></joints><frames><frame type=\"tpose\"><orientation>1 0 0 0 1 0 "
    "0 "
    "0</orientation></frame>"
    "<frame type=\"normal\" index=\"0\"><orientation>1 0 0 0 0.6 0.8 0 0</orientation>"
    "<position>1 2 3 4 5 6</position><jointAngle>1 2 90</jointAngle></frame>"
    "<frame type=\"normal\" index=\"1\"><orientation>1 0 0 0 1 0 0 0</orientation>"
    "<position>1 2 3 4 5 6</position><jointAngle>1 2 91</jointAngle></frame>"
    "</frames></subject></mvnx>";

TEST(MotionTable, OfStorageHasQuaternionsAsFourColumns) {
  const CsvTable table = ParseMotion(kSto, "a.sto", {});
  EXPECT_EQ(table.rows, 2u);
  EXPECT_DOUBLE_EQ(table.Column("time_s")[1], 0.01);
  EXPECT_DOUBLE_EQ(table.Column("radius_r_imu_qx")[0], 0.8);
}

TEST(MotionTable, OfJointAnglesKnowsDegreesAndWindowsLineEnds) {
  const StorageTable storage = ParseStorage(kMot, "a.mot");
  EXPECT_TRUE(storage.in_degrees);
  EXPECT_DOUBLE_EQ(storage.table.Column("elbow_flexion")[1], 13.5);
}

TEST(MotionTable, OfMarkersIsInMetresAndItsBlanksAreGaps) {
  const CsvTable table = ParseMotion(kTrc, "a.trc", {});
  EXPECT_DOUBLE_EQ(table.Column("C7_pz")[0], 3.0);
  EXPECT_TRUE(std::isnan(table.Column("AC_px")[0]));
  EXPECT_TRUE(std::isnan(table.Column("AC_pz")[1]));
}

TEST(MotionTable, OfMvnHasSegmentsAndLeavesOutThePosesOfItsCalibration) {
  const CsvTable table = ParseMotion(kMvnx, "a.mvnx", {});
  EXPECT_EQ(table.rows, 2u);
  EXPECT_DOUBLE_EQ(table.Column("time_s")[1], 1.0 / 60.0);
  EXPECT_DOUBLE_EQ(table.Column("RightForeArm_qx")[0], 0.8);
  EXPECT_DOUBLE_EQ(table.Column("RightForeArm_px")[0], 4.0);
  EXPECT_DOUBLE_EQ(table.Column("jRightElbow_zxy_z")[1], 91.0);
}

TEST(MotionTable, RefusesWhatIsOfAnotherKind) {
  for (const std::string file : {"a.sto", "a.mot", "a.trc", "a.mvnx"})
    EXPECT_THROW(ParseMotion("time_s,a\n1,2\n", file, {}), InputError) << file;
}

void ReadOrRefuse(std::string text, const std::string& file) {
  const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
  switch (*rc::gen::inRange(0, 3)) {
    case 0:
      text[at] = *rc::gen::arbitrary<char>();
      break;
    case 1:
      text.erase(at, *rc::gen::inRange<std::size_t>(1, 20));
      break;
    default:
      text.insert(at, text.substr(at, 15));
  }
  try {
    ParseMotion(text, file, {});
  } catch (const InputError& error) {
    RC_ASSERT(std::string(error.what()).starts_with(file));
  }
}

RC_GTEST_PROP(MotionFuzz, DamagedFilesAreReadOrRefused, ()) {
  ReadOrRefuse(kSto, "a.sto");
  ReadOrRefuse(kMot, "a.mot");
  ReadOrRefuse(kTrc, "a.trc");
  ReadOrRefuse(kMvnx, "a.mvnx");
}

class MotionSamples : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::is_directory(kSamples)) GTEST_SKIP() << "no samples at hand";
  }
  static CsvTable Read(const std::string& name) {
    std::ifstream file(kSamples / name, std::ios::binary);
    return ParseMotion({std::string{std::istreambuf_iterator<char>(file), {}}}, name, {});
  }
  static double Norm(const CsvTable& table, const std::string& label) {
    double squares = 0.0;
    for (const char* ending : {"_qw", "_qx", "_qy", "_qz"})
      squares += std::pow(table.Column(label + ending)[0], 2);
    return std::sqrt(squares);
  }
};

TEST_F(MotionSamples, OfOpenSimAreRead) {
  EXPECT_NEAR(Norm(Read("opensim_sto/imuOrientations.sto"), "torso_imu"), 1.0, 1e-6);
  EXPECT_NEAR(Norm(Read("opensim_sto/myComplexTasksTrial_orientations.sto"), "calcn_r_imu"), 1.0,
              1e-6);
  EXPECT_EQ(Read("opensim_sto/test.sto").Column("v2")[1], 40.0);
  EXPECT_GT(Read("opensim_sto/sampleOutputs.sto").rows, 10u);
  EXPECT_TRUE(Read("opensim_sto/sampleOutputsVec3.sto").Has("/model/ball|linear_velocity_px"));
  EXPECT_EQ(Read("opensim_mot/arm26_InverseKinematics.mot").rows, 121u);
  EXPECT_EQ(Read("opensim_mot/gait10dof18musc_ik_CRLF_line_ending.mot").rows, 15u);
}

TEST_F(MotionSamples, OfMarkersAreInMetresWithGaps) {
  EXPECT_NEAR(Read("trc/dataWithEformat.trc").Column("C7_pz")[0], -1.76, 1e-9);
  const CsvTable example = Read("trc/exampleFormat.trc");
  EXPECT_TRUE(std::isnan(example.Column("marker1_px")[0]));
  EXPECT_TRUE(std::isnan(example.Column("marker2_pz")[2]));
  EXPECT_TRUE(std::isnan(Read("trc/dataWithBlanksForMissingMarkers.trc").Column("C7_px")[0]));
  EXPECT_GT(Read("trc/dataWithNaNsOfDifferentCases.trc").rows, 0u);
}

TEST_F(MotionSamples, OfMvnAreUnitQuaternionsAtSixtyHertz) {
  const CsvTable table = Read("mvnx/test_mocap.mvnx");
  EXPECT_EQ(table.rows, 112u);
  EXPECT_NEAR(table.Column("time_s")[60], 1.0, 1e-12);
  EXPECT_NEAR(Norm(table, "RightUpperArm"), 1.0, 1e-5);
  const double length =
      std::hypot(table.Column("RightForeArm_px")[0] - table.Column("RightUpperArm_px")[0],
                 table.Column("RightForeArm_py")[0] - table.Column("RightUpperArm_py")[0],
                 table.Column("RightForeArm_pz")[0] - table.Column("RightUpperArm_pz")[0]);
  EXPECT_NEAR(length, 0.264, 0.01);
}

}  // namespace
}  // namespace brachium
