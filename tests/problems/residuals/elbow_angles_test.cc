#include "problems/residuals/elbow_angles.h"

#include <gtest/gtest.h>

#include "problems/joint_angles.h"
#include "tests/support/jacobian_check.h"

namespace brachium {
namespace {

using Eigen::Quaterniond;

constexpr Side kSides[] = {Side::kRight, Side::kLeft};

// Both angles as one residual, so that their gradients meet the witnesses of every residual.
struct BothAngles {
  static constexpr int kResiduals = 2;
  using Blocks = std::integer_sequence<int, 4, 4>;
  double s;

  template <typename T>
  void operator()(const T* const* x, T* r) const {
    const auto angles = ElbowFlexionPronation(x[0], x[1], s);
    r[0] = angles.flexion;
    r[1] = angles.pronation;
  }
  void Differentiate(const double* const* x, double* const* J) const {
    const auto gradient = ElbowFlexionPronationGradient(x[0], x[1], s);
    Eigen::Map<RowMajor<2, 3>>{J[0]} << gradient.flexion_U, gradient.pronation_U;
    Eigen::Map<RowMajor<2, 3>>{J[1]} << gradient.flexion_F, gradient.pronation_F;
  }
};

TEST(ElbowFlexionPronation, AreTheClinicalAnglesOnBothSides) {
  std::mt19937 random(1);
  for (const Side side : kSides)
    for (int i = 0; i < 100; ++i) {
      const Quaterniond q_WU = RandomRotation(random), q_UF = RandomRotation(random);
      const Quaterniond q_WF = q_WU * q_UF;
      const auto angles =
          ElbowFlexionPronation(q_WU.coeffs().data(), q_WF.coeffs().data(), Sign(side));
      const ElbowAngles expected = ElbowAnglesFrom(q_UF, side);
      EXPECT_NEAR(angles.flexion, expected.flexion, 1e-9);
      EXPECT_NEAR(angles.pronation, expected.pronation, 1e-9);
    }
}

TEST(ElbowFlexionPronation, DerivativesAgreeForEveryElbowThatIsNotBentSideways) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> flexion(-3.0, 3.0), carrying(-1.2, 1.2);
  for (const Side side : kSides)
    for (int i = 0; i < 50; ++i) {
      const Quaterniond q_WU = RandomRotation(random);
      const Quaterniond q_UF =
          ElbowRotation({flexion(random), carrying(random), flexion(random)}, side);
      EXPECT_TRUE(
          DerivativesAgree(BothAngles{Sign(side)}, {q_WU.coeffs(), (q_WU * q_UF).coeffs()}, 1e-7));
    }
}

}  // namespace
}  // namespace brachium
