#include "problems/alignment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "problems/rotation.h"
#include "tests/support/smooth_motion.h"

namespace brachium {
namespace {

using Eigen::AngleAxisd, Eigen::Quaterniond, Eigen::Vector3d;

const std::vector<double> kTimes = EvenTimes(0.0, 0.05, 400);
const Quaterniond kProximal = Exp(Vector3d(0.4, -1.9, 1.1));
const Quaterniond kDistal = Exp(Vector3d(-2.0, 0.7, 0.9));
const Quaterniond kNoRotation(std::nan(""), 0, 0, 0);

Quaterniond Heading(double angle) { return Quaterniond(AngleAxisd(angle, Vector3d::UnitZ())); }

// Pairs whose reference is left * estimate * right, with signs as a file may have them.
template <typename Motion>
RotationPairs Turned(const Quaterniond& left, const Motion& motion, const Quaterniond& right) {
  RotationPairs pairs{.estimate = Sampled(kTimes, motion), .reference = {}};
  for (std::size_t i = 0; i < kTimes.size(); ++i) {
    pairs.reference.push_back(left * pairs.estimate[i] * right);
    if (i % 2 == 0) pairs.reference.back().coeffs() *= -1.0;
    if (i % 3 == 0) pairs.estimate[i].coeffs() *= -1.0;
  }
  return pairs;
}

double RmsAngle(const RotationPairs& pairs, const RotationAlignment& alignment) {
  const std::vector<Quaterniond> aligned = alignment.Apply(pairs.estimate);
  double sum = 0.0, n = 0.0;
  for (std::size_t i = 0; i < aligned.size(); ++i) {
    if (!pairs.Known(i)) continue;
    sum += Log(Quaterniond(pairs.reference[i].conjugate() * aligned[i])).squaredNorm();
    n += 1.0;
  }
  return std::sqrt(sum / n);
}

// Noise, and every fifth sample far off.
void Disturb(RotationPairs* pairs) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0.0, 0.2);
  for (std::size_t i = 0; i < pairs->size(); ++i)
    pairs->estimate[i] = pairs->estimate[i] *
                         Exp(Vector3d(normal(random), normal(random), normal(random))) *
                         Exp(Vector3d(i % 5 == 0 ? 2.0 : 0.0, 0.0, 0.0));
}

Quaterniond Smooth(double t) { return SmoothRotation(t); }
Quaterniond Hinge(double t) {
  return Quaterniond(AngleAxisd(1.5 * std::sin(t), Vector3d(1, 2, -2).normalized()));
}

TEST(AlignBothSides, FindsTheConstantsThatWerePutIn) {
  const RotationPairs pairs = Turned(kProximal, Smooth, kDistal);
  const RotationAlignment alignment = AlignBothSides(pairs);
  EXPECT_LT(alignment.proximal.angularDistance(kProximal), 1e-9);
  EXPECT_LT(alignment.distal.angularDistance(kDistal), 1e-9);
  EXPECT_LT(RmsAngle(pairs, alignment), 1e-9);
}

TEST(AlignBothSides, LeavesNoErrorOnAHingeWhoseOwnTurnIsOpen) {
  const RotationPairs pairs = Turned(kProximal, Hinge, kDistal);
  EXPECT_LT(RmsAngle(pairs, AlignBothSides(pairs)), 1e-9);
}

TEST(AlignBothSides, IsNoTurnForAHingeThatAgrees) {
  const Quaterniond none = Quaterniond::Identity();
  const RotationAlignment alignment = AlignBothSides(Turned(none, Hinge, none));
  EXPECT_LT(alignment.proximal.angularDistance(none), 1e-6);
  EXPECT_LT(alignment.distal.angularDistance(none), 1e-6);
}

TEST(AlignBothSides, LeavesNoErrorOnAJointThatIsHeldStill) {
  const RotationPairs pairs = Turned(
      kProximal, [](double) { return Exp(Vector3d(0.3, 0.4, 0.5)); }, kDistal);
  EXPECT_LT(RmsAngle(pairs, AlignBothSides(pairs)), 1e-9);
}

TEST(AlignBothSides, WorksOnHalfTurnsAndAcrossGaps) {
  RotationPairs pairs = Turned(
      kProximal, [](double t) { return SmoothRotation(3.0 * t); }, kDistal);
  for (std::size_t i = 100; i < 220; ++i) pairs.estimate[i] = pairs.reference[i] = kNoRotation;
  const RotationAlignment alignment = AlignBothSides(pairs);
  EXPECT_LT(alignment.proximal.angularDistance(kProximal), 1e-9);
}

TEST(AlignBothSides, LeavesTheLeastMeanSquaredAngle) {
  for (const auto& motion : {Smooth, Hinge}) {
    RotationPairs pairs = Turned(kProximal, motion, kDistal);
    Disturb(&pairs);
    const RotationAlignment best = AlignBothSides(pairs);
    const double least = RmsAngle(pairs, best);
    EXPECT_LT(least, RmsAngle(pairs, {.proximal = kProximal, .distal = kDistal}));
    for (const Vector3d axis : {Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()})
      for (const double turn : {1e-3, -1e-3}) {
        RotationAlignment other = best;
        other.proximal = best.proximal * Exp(Vector3d(turn * axis));
        EXPECT_GE(RmsAngle(pairs, other), least);
        other = best;
        other.distal = best.distal * Exp(Vector3d(turn * axis));
        EXPECT_GE(RmsAngle(pairs, other), least);
      }
  }
}

TEST(AlignBothSides, IsNoTurnWithoutASample) {
  const RotationPairs pairs{.estimate = {kNoRotation}, .reference = {kNoRotation}};
  EXPECT_EQ(AlignBothSides(pairs).proximal.w(), 1.0);
  EXPECT_EQ(AlignBothSides({}).distal.w(), 1.0);
}

TEST(AlignHeading, FindsTheHeadingOfASegment) {
  for (const double heading : {-3.1, -1.5, 0.0, 0.7, 3.14}) {
    const auto alignment =
        AlignHeading({Turned(Heading(heading), Smooth, Quaterniond::Identity())}, false);
    EXPECT_NEAR(HeadingOf(alignment[0].proximal), heading, 1e-9);
    EXPECT_LT(alignment[0].distal.angularDistance(Quaterniond::Identity()), 1e-12);
  }
}

TEST(AlignHeading, FindsTheHeadingAndTheFrameOfASegment) {
  for (const double heading : {-3.1, -1.5, 0.0, 0.7, 3.14}) {
    const auto alignment = AlignHeading({Turned(Heading(heading), Smooth, kDistal)}, true);
    EXPECT_NEAR(HeadingOf(alignment[0].proximal), heading, 1e-9);
    EXPECT_LT(alignment[0].distal.angularDistance(kDistal), 1e-9);
  }
}

TEST(AlignHeading, TakesOneHeadingForAllSegments) {
  const auto other = [](double t) { return SmoothRotation(t, 2.0); };
  const auto exact = AlignHeading(
      {Turned(Heading(1.3), Smooth, kDistal), Turned(Heading(1.3), other, kProximal)}, true);
  EXPECT_NEAR(HeadingOf(exact[0].proximal), 1.3, 1e-9);
  EXPECT_LT(exact[1].distal.angularDistance(kProximal), 1e-9);

  const Quaterniond none = Quaterniond::Identity();
  const auto apart =
      AlignHeading({Turned(Heading(0.1), Smooth, none), Turned(Heading(0.3), other, none)}, false);
  EXPECT_NEAR(HeadingOf(apart[0].proximal), 0.2, 1e-9);
  EXPECT_EQ(apart[0].proximal.coeffs(), apart[1].proximal.coeffs());
}

TEST(AlignHeading, RemovesNothingFromASegmentWithoutSamples) {
  const RotationPairs empty{.estimate = {kNoRotation}, .reference = {kNoRotation}};
  const auto alignment = AlignHeading({empty}, true);
  EXPECT_EQ(alignment[0].proximal.w(), 1.0);
  EXPECT_EQ(alignment[0].distal.w(), 1.0);
}

TEST(AlignHeading, DoesNotTurnAWorldThatCannotBeToldApart) {
  const auto spin = [](double t) { return Heading(t); };
  const auto alignment = AlignHeading({Turned(Quaterniond::Identity(), spin, kDistal)}, true);
  EXPECT_NEAR(HeadingOf(alignment[0].proximal), 0.0, 1e-6);
}

PointPairs Points(double heading, const Vector3d& shift) {
  const auto n = static_cast<Eigen::Index>(kTimes.size());
  PointPairs pairs{.estimate = Eigen::Matrix3Xd(3, n), .reference = Eigen::Matrix3Xd(3, n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    pairs.estimate.col(i) = SmoothPoint(kTimes[static_cast<std::size_t>(i)]);
    pairs.reference.col(i) = Heading(heading) * Vector3d(pairs.estimate.col(i)) + shift;
  }
  return pairs;
}

TEST(AlignPoints, FindsHeadingAndShift) {
  const Vector3d shift(3, -2, 1);
  const PointPairs pairs = Points(2.5, shift);
  const PointAlignment alignment = AlignPoints({pairs, pairs});
  EXPECT_NEAR(alignment.heading, 2.5, 1e-12);
  EXPECT_LT((alignment.shift - shift).norm(), 1e-12);
  EXPECT_LT((alignment.Apply(pairs.estimate) - pairs.reference).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(AlignPoints, DoWithoutHeightAndWithGaps) {
  PointPairs pairs = Points(-0.8, Vector3d(1, 1, 1));
  pairs.reference.row(2).setConstant(std::nan(""));
  pairs.reference.col(17).setConstant(std::nan(""));
  const PointAlignment alignment = AlignPoints({pairs});
  EXPECT_NEAR(alignment.heading, -0.8, 1e-12);
  EXPECT_LT((alignment.shift - Vector3d(1, 1, 0)).norm(), 1e-12);
}

TEST(AlignPoints, IsNoMoveWithoutAPoint) {
  EXPECT_EQ(AlignPoints({}).heading, 0.0);
  EXPECT_EQ(AlignPoints({}).shift.norm(), 0.0);
}

}  // namespace
}  // namespace brachium
