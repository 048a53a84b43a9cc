#include "problems/residuals/as_mounted.h"

#include <gtest/gtest.h>

#include "problems/arm_model.h"
#include "problems/joint_angles.h"
#include "problems/residuals/elbow_adduction.h"
#include "problems/residuals/held_pose.h"
#include "problems/residuals/segment_chain.h"
#include "tests/support/jacobian_check.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector2d, Eigen::Vector3d;

const Vector2d kCarrying(0.2, 0.0);
const Eigen::Matrix<double, 1, 1> kNoDeviation(0.0);
const Vector3d kNoSkin = Vector3d::Zero();

double Adduction(const Quaterniond& q_WU, const Quaterniond& q_WF, const Vector3d& turn_U,
                 const Vector3d& turn_F) {
  return ResidualAt(
      AsMounted(ElbowAdduction(Side::kRight, 1.0)),
      {q_WU.coeffs(), q_WF.coeffs(), kCarrying, kNoDeviation, turn_U, turn_F, kNoSkin, kNoSkin})[0];
}

TEST(AsMounted, IsTheResidualItselfWhereSensorsSitAsTold) {
  std::mt19937 random(1);
  const SegmentChain<3> chain(0.01);
  const BlockValues x = RandomValues(SegmentChain<3>::Blocks(), random);
  BlockValues mounted = x;
  mounted.insert(mounted.end(), 6, Vector3d::Zero());
  EXPECT_LT((ResidualAt(AsMounted(chain), mounted) - ResidualAt(chain, x)).norm(), 1e-9);
}

// A sensor told to sit at R_told that sits at Exp(δ) R_told shows a segment that is turned.
TEST(AsMounted, FindsTheSegmentsBehindSensorsThatSitOtherwise) {
  std::mt19937 random(1);
  const Quaterniond q_told = RandomRotation(random), q_WU = RandomRotation(random);
  const Vector3d turn_U(0.05, -0.1, 0.2), turn_F(-0.1, 0.04, 0.08);
  const Quaterniond q_WF = q_WU * ElbowRotation({1.0, kCarrying[0], 0.7}, Side::kRight);
  const auto shown = [&](const Quaterniond& q_WB, const Vector3d& turn) {
    const Quaterniond q_WS = q_WB * (Exp<double>(turn) * q_told);
    return q_WS * q_told.conjugate();
  };
  EXPECT_NEAR(Adduction(shown(q_WU, turn_U), shown(q_WF, turn_F), turn_U, turn_F), 0.0, 1e-12);
  EXPECT_GT(std::abs(Adduction(shown(q_WU, turn_U), shown(q_WF, turn_F), Vector3d::Zero(),
                               Vector3d::Zero())),
            0.03);
}

TEST(AsMounted, HearsNothingFromAnElbowOfTheZerosOfFlexionAndPronation) {
  std::mt19937 random(1);
  const Quaterniond q_WU = RandomRotation(random), q_WF = RandomRotation(random);
  const Vector3d zero = Vector3d::Zero();
  const double untold = Adduction(q_WU, q_WF, zero, zero);
  EXPECT_NEAR(Adduction(q_WU, q_WF, 0.2 * Vector3d::UnitZ(), zero), untold, 1e-12);
  EXPECT_NEAR(Adduction(q_WU, q_WF, zero, 0.2 * Vector3d::UnitY()), untold, 1e-12);
}

TEST(AsMounted, DerivativesAgree) {
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(AsMounted(SegmentChain<2>(0.5))));
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(AsMounted(ElevationHeldPose(0.4, 0.2))));
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(
      AsMounted(ElbowHeldPose(ElbowAngle::kPronation, Side::kLeft, 0.3, 0.2))));
}

}  // namespace
}  // namespace brachium
