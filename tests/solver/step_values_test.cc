#include "solver/step_values.h"

#include <gtest/gtest.h>

#include "solver/window.h"
#include "tests/support/simulated_trial.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

// An arm whose windows have been solved, and steps of it.
class Steps : public testing::Test {
 protected:
  ArmProblem problem_{Brisk(16).observations, {}, 0.05};
  State state_ = problem_.PriorState();
  FrontPlan plan_{problem_};
  const int knots_ = problem_.size().knots;
  std::vector<double> step_;

  void SetUp() override {
    SolveForward(problem_, state_, {}, {});
    plan_.Build(problem_, state_, {}, {.end_knot = knots_, .last_knot = knots_});
    step_.assign(static_cast<std::size_t>(plan_.columns()), 0.0);
  }

  Eigen::Map<Vector3d> Step(int unknown) {
    const auto& variable = plan_.variables()[static_cast<std::size_t>(plan_.IndexOf(unknown))];
    return Eigen::Map<Vector3d>(&step_[static_cast<std::size_t>(variable.column)]);
  }
  Quaterniond Attitude(int knot, int sensor) {
    return Eigen::Map<Quaterniond>(state_.Attitude(knot, sensor));
  }
  Vector3d Vector(double* x) { return Eigen::Map<Vector3d>(x); }

  // To first order: all of the arm about the vertical through the origin [rad].
  void TurnTheArm(double angle) {
    const auto turned = [&](const double* x) -> Vector3d {
      return angle * Vector3d::UnitZ().cross(Eigen::Map<const Vector3d>(x));
    };
    for (int knot = 0; knot < knots_; ++knot) {
      Step(problem_.Root(knot, 0)) = turned(state_.Root(knot, 0));
      for (int sensor = 0; sensor < 2; ++sensor) {
        Step(problem_.Attitude(knot, sensor)) =
            angle * (Attitude(knot, sensor).conjugate() * Vector3d::UnitZ());
        Step(problem_.Place(knot, sensor)) = turned(state_.Place(knot, sensor));
        Step(problem_.Velocity(knot, sensor)) = turned(state_.Velocity(knot, sensor));
      }
    }
  }
};

TEST_F(Steps, LeaveSensorsWhereTheChainPutsThemHoweverFarTheArmTurns) {
  for (int knot = 0; knot < knots_; ++knot)
    for (int sensor = 0; sensor < 2; ++sensor)
      Eigen::Map<Vector3d>(state_.Place(knot, sensor)) =
          problem_.PlaceOnChain(state_, knot, sensor);
  TurnTheArm(1.0);
  StepValues values(problem_, state_, plan_);
  values.Save();
  values.Set(step_, 1.0);
  for (int knot = 0; knot < knots_; ++knot)
    for (int sensor = 0; sensor < 2; ++sensor)
      EXPECT_LT(
          (Vector(state_.Place(knot, sensor)) - problem_.PlaceOnChain(state_, knot, sensor)).norm(),
          1e-6);
}

TEST_F(Steps, AreLinearToFirstOrder) {
  TurnTheArm(1e-6);
  const Vector3d place = Vector(state_.Place(10, 1)), step = Step(problem_.Place(10, 1));
  StepValues values(problem_, state_, plan_);
  values.Save();
  values.Set(step_, 1.0);
  EXPECT_LT((Vector(state_.Place(10, 1)) - place - step).norm(), 1e-11);
}

TEST_F(Steps, AreTakenBackToTheLastDigit) {
  TurnTheArm(0.5);
  const Vector3d place = Vector(state_.Place(10, 1));
  const Eigen::Vector4d attitude = Attitude(10, 1).coeffs();
  StepValues values(problem_, state_, plan_);
  values.Save();
  values.Set(step_, 0.7);
  EXPECT_NE(Vector(state_.Place(10, 1)), place);
  values.Restore();
  EXPECT_EQ(Vector(state_.Place(10, 1)), place);
  EXPECT_EQ(Attitude(10, 1).coeffs(), attitude);
}

}  // namespace
}  // namespace brachium
