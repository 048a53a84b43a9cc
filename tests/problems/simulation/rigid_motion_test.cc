#include "problems/simulation/rigid_motion.h"

#include <gtest/gtest.h>

#include "problems/rotation.h"

namespace brachium {
namespace {

using Eigen::Vector3d;

constexpr double kStep = 1e-5;

Moving Swing(double amplitude, double frequency, double t) {
  Motion motion(0.3);
  motion.AddSinusoid(amplitude, frequency, 0.5);
  return motion.At(t);
}

TurningFrame Tumble(double t) {
  return About(Vector3d::UnitZ(), Swing(1.2, 0.6, t)) *
         About(Vector3d::UnitX(), Swing(-0.8, 0.9, t)) *
         About(Vector3d::UnitY(), Swing(2.0, 0.4, t));
}

BodyMotion Body(double t) {
  return {.turning = Tumble(t),
          .joint_W = PointOf(Swing(0.1, 0.3, t), Swing(0.2, 0.5, t), Swing(0.3, 0.8, t))};
}

TEST(TurningFrame, HasTheRateOfItsAttitude) {
  for (double t = 0.0; t < 3.0; t += 0.1) {
    const Vector3d turn = Log<double>(Tumble(t - kStep).q_AB.conjugate() * Tumble(t + kStep).q_AB);
    EXPECT_TRUE(Tumble(t).omega_AB_B.isApprox(turn / (2 * kStep), 1e-7)) << "at " << t;
  }
}

TEST(TurningFrame, HasTheAccelerationOfItsRate) {
  for (double t = 0.0; t < 3.0; t += 0.1) {
    const Vector3d change = Tumble(t + kStep).omega_AB_B - Tumble(t - kStep).omega_AB_B;
    EXPECT_TRUE(Tumble(t).alpha_AB_B.isApprox(change / (2 * kStep), 1e-7)) << "at " << t;
  }
}

TEST(MovingPoint, HasTheVelocityAndAccelerationOfItsPositionWhenItMovesOnATurningBody) {
  const auto point = [](double t) {
    return PointOn(Body(t), PointOf(Swing(0.3, 0.7, t), Swing(-0.2, 1.1, t), Swing(0.1, 0.2, t)));
  };
  for (double t = 0.0; t < 3.0; t += 0.1) {
    const MovingPoint before = point(t - kStep), here = point(t), after = point(t + kStep);
    EXPECT_TRUE(here.v.isApprox((after.p - before.p) / (2 * kStep), 1e-7)) << "at " << t;
    EXPECT_TRUE(here.a.isApprox((after.v - before.v) / (2 * kStep), 1e-7)) << "at " << t;
  }
}

TEST(MovingPoint, SumsAndProductsHaveTheirDerivatives) {
  const auto a = [](double t) {
    return PointOf(Swing(0.3, 0.7, t), Swing(-0.2, 1.1, t), Swing(0.1, 0.2, t));
  };
  const auto b = [](double t) {
    return PointOf(Swing(0.5, 0.4, t), Swing(0.3, 0.9, t), Swing(-0.6, 0.3, t));
  };
  const auto made = [&](double t) {
    return Unit(Cross(a(t), b(t)) + Dot(a(t), b(t)) * (a(t) - b(t)));
  };
  for (double t = 0.0; t < 3.0; t += 0.1) {
    const MovingPoint before = made(t - kStep), here = made(t), after = made(t + kStep);
    EXPECT_NEAR(here.p.norm(), 1.0, 1e-14);
    EXPECT_LT((here.v - (after.p - before.p) / (2 * kStep)).norm(), 1e-6) << "at " << t;
    EXPECT_LT((here.a - (after.v - before.v) / (2 * kStep)).norm(), 1e-6) << "at " << t;
  }
}

}  // namespace
}  // namespace brachium
