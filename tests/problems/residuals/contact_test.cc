#include "problems/residuals/contact.h"

#include <gtest/gtest.h>

#include "problems/residuals/as_mounted.h"
#include "tests/support/jacobian_check.h"

namespace brachium {
namespace {

using Eigen::AngleAxisd, Eigen::Quaterniond, Eigen::Vector3d;

constexpr double kSigma = 0.01;  // [m]
const Vector3d kUpperArm(0.0, -0.3, 0.0), kForearm(0.01, -0.25, 0.02);

// An arm of two segments in some posture.
struct Arm {
  Quaterniond q_WU, q_WF;
  Vector3d p_W;

  explicit Arm(unsigned seed) {
    std::mt19937 random(seed);
    q_WU = RandomRotation(random);
    q_WF = RandomRotation(random);
    p_W = RandomVector(3, random);
  }
  Vector3d Wrist() const { return p_W + q_WU * kUpperArm + q_WF * kForearm; }
  void TurnAndShift(double heading, const Vector3d& shift) {
    const Quaterniond q(AngleAxisd(heading, Vector3d::UnitZ()));
    q_WU = q * q_WU;
    q_WF = q * q_WF;
    p_W = q * p_W + shift;
  }
  BlockValues WithPlace(const Vector3d& place) const {
    return {q_WU.coeffs(), q_WF.coeffs(), p_W, place, kForearm, kUpperArm};
  }
  BlockValues WithHeight(double height) const {
    return {q_WU.coeffs(), q_WF.coeffs(), p_W, Eigen::VectorXd::Constant(1, height),
            kUpperArm,     kForearm};
  }
};

// How much the whole arm's heading would be held, its place in tow: |Σ J_i v_i|² along that turn.
template <typename Residual>
double HeadingInformation(const Residual& residual, const BlockValues& x,
                          const std::vector<bool>& is_point) {
  Eigen::VectorXd r;
  const std::unique_ptr<TangentCost> cost(MakeCost(residual));
  const JacobianBlocks J = TangentJacobians(*cost, x, &r);
  Eigen::VectorXd along = Eigen::VectorXd::Zero(Residual::kResiduals);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i].size() == 4)
      along += J[i] * (Eigen::Map<const Quaterniond>(x[i].data()).conjugate() * Vector3d::UnitZ());
    else if (is_point[i])
      along += J[i] * Vector3d::UnitZ().cross(Vector3d(x[i]));
  }
  return along.squaredNorm();
}

TEST(ContactPlace, IsZeroThereAndOneAtOneSigmaInAnyDirection) {
  const ContactPlace<2> contact(kSigma);
  for (unsigned seed = 0; seed < 10; ++seed) {
    const Arm arm(seed);
    EXPECT_LT(ResidualAt(contact, arm.WithPlace(arm.Wrist())).norm(), 1e-12);
    std::mt19937 random(seed);
    const Vector3d off = kSigma * RandomVector(3, random).normalized();
    EXPECT_NEAR(ResidualAt(contact, arm.WithPlace(arm.Wrist() + off)).norm(), 1.0, 1e-12);
  }
}

TEST(ContactPlace, KnowsNothingOfHeadingAndPlaceOfTheWholeHoweverFarOffItIs) {
  const ContactPlace<2> contact(kSigma);
  Arm arm(1);
  const Vector3d off(0.05, -0.02, 0.03), shift(1.0, 2.0, 3.0);
  const BlockValues x = arm.WithPlace(arm.Wrist() + off);
  const Eigen::VectorXd r = ResidualAt(contact, x);
  EXPECT_LT(HeadingInformation(contact, x, {false, false, true, true, false, false}), 1e-16);
  arm.TurnAndShift(0.8, shift);
  const Vector3d off_turned = AngleAxisd(0.8, Vector3d::UnitZ()) * off;
  EXPECT_LT((ResidualAt(contact, arm.WithPlace(arm.Wrist() + off_turned)) - r).norm(), 1e-10);
}

TEST(ContactHeight, IsHowFarAboveThePlaceThePointIsAndNothingElse) {
  const ContactHeight<2> contact(kSigma);
  for (unsigned seed = 0; seed < 10; ++seed) {
    Arm arm(seed);
    const double height = arm.Wrist().z();
    EXPECT_NEAR(ResidualAt(contact, arm.WithHeight(height))[0], 0.0, 1e-12);
    EXPECT_NEAR(ResidualAt(contact, arm.WithHeight(height - kSigma))[0], 1.0, 1e-12);
    arm.TurnAndShift(2.0, {0.4, -0.7, 0.0});
    EXPECT_NEAR(ResidualAt(contact, arm.WithHeight(height - kSigma))[0], 1.0, 1e-12);
  }
}

TEST(ContactHeight, KnowsNothingOfTheHeading) {
  const Arm arm(1);
  EXPECT_LT(HeadingInformation(ContactHeight<2>(kSigma), arm.WithHeight(arm.Wrist().z() + 0.1),
                               {false, false, true, false, false, false}),
            1e-16);
}

TEST(Contact, DerivativesAgree) {
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(ContactPlace<2>(0.5)));
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(ContactHeight<1>(0.5)));
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(ContactHeight<4>(0.5)));
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(AsMounted(ContactPlace<2>(0.5))));
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(AsMounted(ContactHeight<3>(0.5))));
}

}  // namespace
}  // namespace brachium
