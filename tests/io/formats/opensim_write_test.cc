#include "io/formats/opensim_write.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/formats/motion_table.h"
#include "io/output_folder.h"
#include "problems/joint_angles.h"
#include "problems/rotation.h"
#include "tests/support/temporary_folder.h"

namespace brachium {
namespace {

using testing::HasSubstr;

// A bent arm that is lifted, seen with a thorax; the forearm is unknown at the last instant.
Estimate SomeEstimate() {
  Estimate estimate;
  for (int i = 0; i < 4; ++i) {
    estimate.time.push_back(0.01 * i);
    const Eigen::Quaterniond q_WT(std::sqrt(0.5), std::sqrt(0.5), 0.0, 0.0);
    const Eigen::Quaterniond q_TU = Exp<double>({0.0, 0.5, 0.0}) *
                                    Exp<double>({-0.7 - 0.01 * i, 0.0, 0.0}) *
                                    Exp<double>({0.0, 0.2, 0.0});
    const Eigen::Quaterniond q_UF = ElbowRotation({1.2, 0.1, 0.9}, Side::kRight);
    estimate.q_WB[Segment::kThorax].push_back(q_WT);
    estimate.q_WB[Segment::kUpperArm].push_back(q_WT * q_TU);
    estimate.q_WB[Segment::kForearm].push_back(q_WT * q_TU * q_UF);
  }
  estimate.q_WB[Segment::kForearm].back().coeffs().setConstant(NAN);
  return estimate;
}

class OpenSim : public testing::Test {
 protected:
  void SetUp() override { WriteOpenSim(disk_.File("out"), SomeEstimate(), false); }
  CsvTable Read(const std::string& name) const {
    return ParseMotion(disk_.Read("out/" + name), name, {});
  }
  TemporaryFolder disk_;
};

TEST_F(OpenSim, OrientationsAreReadBackToTheSameBits) {
  const CsvTable table = Read("orientations.sto");
  ASSERT_EQ(table.rows, 3u);
  EXPECT_EQ(table.names[1], "torso_imu_qw");
  const Estimate estimate = SomeEstimate();
  EXPECT_EQ(table.Column("humerus_r_imu_qy")[2], estimate.q_WB.at(Segment::kUpperArm)[2].y());
  EXPECT_EQ(table.Column("radius_r_imu_qw")[1], estimate.q_WB.at(Segment::kForearm)[1].w());
}

TEST_F(OpenSim, OrientationsBeginAsOpenSimWantsThem) {
  EXPECT_THAT(disk_.Read("out/orientations.sto"),
              testing::StartsWith("DataRate=100.000000\nDataType=Quaternion\nversion=3\n"
                                  "OpenSimVersion=4.4\nendheader\ntime\ttorso_imu\thumerus_r_imu\t"
                                  "radius_r_imu\n0\t"));
}

TEST_F(OpenSim, JointAnglesAreDegreesOfTheModelsCoordinates) {
  const StorageTable storage = ParseStorage(disk_.Read("out/joint_angles.mot"), "joint_angles.mot");
  EXPECT_TRUE(storage.in_degrees);
  const auto first = [&](const char* name) { return storage.table.Column(name)[0] * M_PI / 180.0; };
  EXPECT_NEAR(first("elbow_flexion"), 1.2, 1e-9);
  EXPECT_NEAR(first("pro_sup"), 0.9 - M_PI / 2.0, 1e-9);
  EXPECT_NEAR(first("elv_angle"), 0.5, 1e-9);
  EXPECT_NEAR(first("shoulder_elv"), 0.7, 1e-9);
  EXPECT_NEAR(first("shoulder_rot"), 0.7, 1e-9);
  EXPECT_EQ(storage.table.rows, 3u);
}

TEST_F(OpenSim, SetupsTurnZUpIntoYUpAndNameTheOrientations) {
  for (const std::string name : {"out/placer_setup.xml", "out/ik_setup.xml"})
    EXPECT_THAT(disk_.Read(name),
                testing::AllOf(HasSubstr("<sensor_to_opensim_rotations>-1.5707963 0 0<"),
                               HasSubstr(">orientations.sto<")));
}

TEST_F(OpenSim, AnOlderFolderIsNotReplacedUnasked) {
  Estimate other = SomeEstimate();
  other.time[0] = -1.0;
  EXPECT_THROW(WriteOpenSim(disk_.File("out"), other, false), OutputExists);
}

}  // namespace
}  // namespace brachium
