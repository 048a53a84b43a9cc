#include "io/reference_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace brachium {
namespace {

using testing::Contains, testing::HasSubstr, testing::SizeIs;

const std::set<Segment> kRecorded = {Segment::kUpperArm, Segment::kForearm};

ReferenceFile Parse(const std::string& text, const ReferenceEntry& entry = {},
                    Findings* findings = nullptr) {
  Findings unread;
  return ParseReference(text, "reference.csv", entry, kRecorded,
                        findings != nullptr ? findings : &unread);
}

TEST(Reference, MayHoldSomeSegmentsAndPointsOnly) {
  const Reference reference = Parse(
                                  "time_s,forearm_qw,forearm_qx,forearm_qy,forearm_qz,wrist_px,"
                                  "wrist_py,wrist_pz,c7_px\n"
                                  "0,0,1,0,0,1,2,3,text\n0.1,0,0,1,0,4,5,6,text\n")
                                  .reference;
  ASSERT_THAT(reference.q_VB, SizeIs(1));
  EXPECT_EQ(reference.q_VB.at(Segment::kForearm)[1].y(), 1.0);
  ASSERT_THAT(reference.p_V, SizeIs(1));
  EXPECT_EQ(reference.p_V.at("wrist")[1], Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(reference.frames, Reference::Frames::kSegment);
}

TEST(Reference, RenamesSegmentsAndPoints) {
  ReferenceEntry entry;
  entry.columns = {{"upper_arm", "seg1"}, {"hand", "foot"}};
  const Reference reference =
      Parse(
          "time_s,seg1_qw,seg1_qx,seg1_qy,seg1_qz,seg1_px,seg1_py,seg1_pz,"
          "foot_px,foot_py,foot_pz,foot_qw,foot_qx,foot_qy,foot_qz\n"
          "0,1,0,0,0,1,2,3,4,5,6,0,1,0,0\n1e-2,1,0,0,0,1,2,3,4,5,6,0,1,0,0\n",
          entry)
          .reference;
  EXPECT_EQ(reference.q_VB.at(Segment::kUpperArm)[0].w(), 1.0);
  EXPECT_EQ(reference.q_VB.at(Segment::kHand)[0].x(), 1.0);
  EXPECT_EQ(reference.p_V.at("upper_arm")[0], Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(reference.p_V.at("hand")[0], Eigen::Vector3d(4, 5, 6));
}

TEST(Reference, LeavesHeightOpenWhereThereIsNone) {
  const Reference reference = Parse("time_s,hand_px,hand_py\n0,1,2\n0.1,3,4\n").reference;
  EXPECT_EQ(reference.p_V.at("hand")[1].head<2>(), Eigen::Vector2d(3, 4));
  EXPECT_TRUE(std::isnan(reference.p_V.at("hand")[1].z()));
}

TEST(Reference, TakesEmptyCellsForGaps) {
  const Reference reference = Parse(
                                  "time_s,hand_qw,hand_qx,hand_qy,hand_qz,hand_px,hand_py,hand_pz\n"
                                  "0,,,,,1,2,3\n0.1,1,,0,0,,,\n0.2,1,0,0,0,1,2,3\n")
                                  .reference;
  ASSERT_THAT(reference.time, SizeIs(3));
  const auto& q_VH = reference.q_VB.at(Segment::kHand);
  EXPECT_TRUE(q_VH[0].coeffs().array().isNaN().all());
  EXPECT_TRUE(q_VH[1].coeffs().array().isNaN().all());
  EXPECT_TRUE(q_VH[2].coeffs().allFinite());
  EXPECT_TRUE(reference.p_V.at("hand")[1].array().isNaN().all());
}

constexpr const char* kTwoClusters =
    "time_s,upper_arm_qw,upper_arm_qx,upper_arm_qy,upper_arm_qz,"
    "forearm_qw,forearm_qx,forearm_qy,forearm_qz\n"
    "0,0.6,0.8,0,0,1,0,0,0\n0.1,0.6,0.8,0,0,,,,\n";

TEST(Reference, TurnsClustersThatAreKnownToTheirSegments) {
  ReferenceEntry entry;
  entry.frames = Reference::Frames::kCluster;
  entry.q_BC = {{Segment::kUpperArm, Eigen::Quaterniond(0.6, 0.8, 0.0, 0.0)},
                {Segment::kForearm, Eigen::Quaterniond(0.0, 0.0, 1.0, 0.0)}};
  const Reference reference = Parse(kTwoClusters, entry).reference;
  EXPECT_EQ(reference.frames, Reference::Frames::kSegment);
  EXPECT_NEAR(reference.q_VB.at(Segment::kUpperArm)[0].w(), 1.0, 1e-12);
  EXPECT_NEAR(reference.q_VB.at(Segment::kForearm)[0].y(), -1.0, 1e-12);
  EXPECT_TRUE(reference.q_VB.at(Segment::kForearm)[1].coeffs().hasNaN());
}

TEST(Reference, StaysOneOfClustersWhereNotAllAreKnown) {
  ReferenceEntry entry;
  entry.frames = Reference::Frames::kCluster;
  entry.q_BC = {{Segment::kForearm, Eigen::Quaterniond(0.0, 0.0, 1.0, 0.0)}};
  Findings findings;
  const Reference reference = Parse(kTwoClusters, entry, &findings).reference;
  EXPECT_EQ(reference.frames, Reference::Frames::kCluster);
  EXPECT_EQ(reference.q_VB.at(Segment::kForearm)[0].w(), 1.0);
  EXPECT_THAT(findings.warnings, Contains(HasSubstr("clusters lacks upper_arm")));
}

TEST(Reference, TurnsAVerticalYUp) {
  ReferenceEntry entry;
  entry.up_is_y = true;
  const Reference reference = Parse(
                                  "time_s,hand_qw,hand_qx,hand_qy,hand_qz,hand_px,hand_py,hand_pz\n"
                                  "0,0.6,0.8,0,0,1,2,3\n0.1,1,0,0,0,1,2,3\n",
                                  entry)
                                  .reference;
  EXPECT_EQ(reference.p_V.at("hand")[0], Eigen::Vector3d(1, -3, 2));
  const Eigen::Vector3d y_V = reference.q_VB.at(Segment::kHand)[1] * Eigen::Vector3d::UnitY();
  EXPECT_TRUE(y_V.isApprox(Eigen::Vector3d::UnitZ(), 1e-12));
  const Eigen::Vector3d v(0.3, -0.2, 0.7);
  const Eigen::Vector3d v_Y = Eigen::Quaterniond(0.6, 0.8, 0, 0) * v;
  EXPECT_TRUE((reference.q_VB.at(Segment::kHand)[0] * v)
                  .isApprox(Eigen::Vector3d(v_Y.x(), -v_Y.z(), v_Y.y()), 1e-12));
}

TEST(Reference, NormalisesQuaternionsThatAreNearlyOfUnitLength) {
  const Reference reference =
      Parse("time_s,hand_qw,hand_qx,hand_qy,hand_qz\n0,1.0005,0,0,0\n0.1,1,0,0,0\n").reference;
  EXPECT_DOUBLE_EQ(reference.q_VB.at(Segment::kHand)[0].norm(), 1.0);
}

TEST(Reference, WarnsOfMillimetres) {
  Findings findings;
  Parse("time_s,hand_px,hand_py\n0,1000,200\n0.1,1001,200\n", {}, &findings);
  EXPECT_THAT(findings.warnings, Contains(HasSubstr("looks like millimetres")));
}

TEST(Reference, LeavesOutRowsWhoseTimeRunsBack) {
  Findings findings;
  const ReferenceFile file =
      Parse("time_s,hand_px,hand_py\n0,1,2\n0.1,3,4\n0.05,5,6\n0.1,5,6\n0.2,7,8\n0.3,9,9\n", {},
            &findings);
  EXPECT_EQ(file.reference.time.size(), 4u);
  EXPECT_EQ(file.facts.samples, 4u);
  EXPECT_THAT(findings.repairs, Contains(HasSubstr("2 rows left out")));
}

}  // namespace
}  // namespace brachium
