#include "problems/residuals/segment_chain.h"

#include <gtest/gtest.h>

#include "tests/support/jacobian_check.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d, Eigen::VectorXd;

constexpr double kSigma = 0.002;

template <int kChain>
struct Example {
  BlockValues x;  // as the residual has them, the sensor in its place

  static Vector3d Joint(int i) { return {0.02 * i, -0.3 + 0.03 * i, 0.01}; }

  Example() {
    std::mt19937 random(7);
    const Vector3d root(0.3, -0.2, 1.1), sensor(0.03, -0.15, 0.02);
    Vector3d place = root;
    std::vector<Quaterniond> q_WB;
    for (int i = 0; i < kChain; ++i) {
      q_WB.push_back(RandomRotation(random));
      place += q_WB.back() * (i + 1 == kChain ? sensor : Joint(i));
      x.push_back(q_WB.back().coeffs());
    }
    x.insert(x.end(), {root, place, sensor});
    for (int i = 0; i + 1 < kChain; ++i) x.push_back(Joint(i));
  }

  static SegmentChain<kChain> Residual() { return SegmentChain<kChain>(kSigma); }
  static constexpr std::size_t kRoot = kChain, kPlace = kChain + 1, kSensor = kChain + 2;
};

template <typename Length>
class SegmentChainOf : public ::testing::Test {};

using Lengths = ::testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
                                 std::integral_constant<int, 3>, std::integral_constant<int, 4>>;
TYPED_TEST_SUITE(SegmentChainOf, Lengths);

TYPED_TEST(SegmentChainOf, IsZeroWhereTheSensorIsAtItsPlaceOnTheLastSegment) {
  const Example<TypeParam::value> example;
  EXPECT_LT(ResidualAt(example.Residual(), example.x).norm(), 1e-12);
}

TYPED_TEST(SegmentChainOf, IsOneAtOneSigmaInAnyDirection) {
  Example<TypeParam::value> example;
  example.x[example.kPlace] += kSigma * Vector3d(0.6, 0.0, -0.8);
  EXPECT_NEAR(ResidualAt(example.Residual(), example.x).norm(), 1.0, 1e-9);
}

TYPED_TEST(SegmentChainOf, IsBlindToTheHeadingAndThePlaceOfTheWhole) {
  std::mt19937 random(1);
  const auto residual = Example<TypeParam::value>::Residual();
  BlockValues x = RandomValues(typename SegmentChain<TypeParam::value>::Blocks(), random);
  const VectorXd r = ResidualAt(residual, x);
  const Quaterniond q_VW(Eigen::AngleAxisd(0.9, Vector3d::UnitZ()));
  std::vector<bool> is_world(x.size(), false);
  is_world[Example<TypeParam::value>::kRoot] = is_world[Example<TypeParam::value>::kPlace] = true;
  x = TurnedWorld(q_VW, x, is_world);
  const Vector3d shift(3.0, -2.0, 1.0);
  x[Example<TypeParam::value>::kRoot] += shift;
  x[Example<TypeParam::value>::kPlace] += shift;
  EXPECT_LT((ResidualAt(residual, x) - r).norm(), 1e-9);
}

TYPED_TEST(SegmentChainOf, SeesALongerSegmentWhereASensorIsFartherAlong) {
  constexpr int kChain = TypeParam::value;
  Example<kChain> example;
  const auto lengthen = [&](std::size_t lever) {
    example.x[lever] *= 1.01;
    EXPECT_NEAR(ResidualAt(example.Residual(), example.x).norm(),
                0.01 / 1.01 * example.x[lever].norm() / kSigma, 1e-6);
    example.x[lever] /= 1.01;
  };
  for (std::size_t lever = example.kSensor; lever < example.x.size(); ++lever) lengthen(lever);
}

TYPED_TEST(SegmentChainOf, DerivativesAgree) {
  const Example<TypeParam::value> example;
  EXPECT_TRUE(DerivativesAgreeAtRandomPoints(example.Residual()));
  EXPECT_TRUE(DerivativesAgree(example.Residual(), example.x));
}

}  // namespace
}  // namespace brachium
