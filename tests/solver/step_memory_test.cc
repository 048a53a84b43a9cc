#include "solver/step_memory.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace brachium {
namespace {

constexpr int kColumns = 8;

std::vector<double> Numbers(const Eigen::VectorXd& vector) {
  return {vector.data(), vector.data() + vector.size()};
}

// ½ xᵀ A x, taken for ½ xᵀ H x: A bends more than H in one direction and less in another.
struct Bowl {
  Eigen::MatrixXd H, A;
  explicit Bowl(double more, double less) {
    const Eigen::VectorXd units = Eigen::VectorXd::LinSpaced(kColumns, 1.0, 50.0);
    H = units.cwiseAbs2().asDiagonal();
    Eigen::VectorXd u = Eigen::VectorXd::Ones(kColumns).normalized();
    Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(kColumns, -1.0, 1.0).normalized();
    const Eigen::MatrixXd bend = more * u * u.transpose() - less * v * v.transpose();
    A = H + units.asDiagonal() * bend * units.asDiagonal();
  }
  Eigen::VectorXd Gradient(const Eigen::VectorXd& x) const { return A * x; }
  Eigen::VectorXd Step(const Eigen::VectorXd& x) const { return -H.ldlt().solve(Gradient(x)); }
  double Length2(const Eigen::VectorXd& step) const { return step.dot(H * step); }
};

// Steps, mixed or not, from a place far away; returns the length of the last.
double LengthAfter(const Bowl& bowl, int steps, bool mixed) {
  StepMemory memory;
  Eigen::VectorXd x = Eigen::VectorXd::Constant(kColumns, 3.0);
  for (int i = 0; i < steps; ++i) {
    const Eigen::VectorXd f = bowl.Step(x);
    memory.Stand(Numbers(f), Numbers(bowl.Gradient(x)), bowl.Length2(f));
    std::vector<double> step = Numbers(f);
    if (mixed) memory.Mix(step);
    x += Eigen::Map<const Eigen::VectorXd>(step.data(), kColumns);
    memory.Go(step, 1.0);
  }
  return std::sqrt(bowl.Length2(bowl.Step(x)));
}

TEST(StepMemory, ReachesTheBottomOfABowlThatStepsAloneCreepOrSwingIn) {
  const Bowl bowl(0.9, 0.9);
  EXPECT_GT(LengthAfter(bowl, 5, false), 10.0);
  EXPECT_LT(LengthAfter(bowl, 5, true), 1e-6);
}

TEST(StepMemory, MixesNothingBeforeThereAreTwoSteps) {
  const Bowl bowl(0.9, 0.9);
  StepMemory memory;
  std::vector<double> mixed;
  EXPECT_FALSE(memory.Mix(mixed));
  const Eigen::VectorXd x = Eigen::VectorXd::Ones(kColumns), f = bowl.Step(x);
  memory.Stand(Numbers(f), Numbers(bowl.Gradient(x)), bowl.Length2(f));
  EXPECT_FALSE(memory.Mix(mixed));
}

// Quadratic convergence needs no help: what steps did far away says nothing here.
TEST(StepMemory, LetsStepsAloneThatShrinkWell) {
  StepMemory memory;
  std::vector<double> mixed;
  memory.Stand({1.0, 0.0}, {-1.0, 0.0}, 1.0);
  memory.Go({1.0, 0.0}, 1.0);
  memory.Stand({0.1, 0.0}, {-0.1, 0.0}, 0.01);
  EXPECT_FALSE(memory.Mix(mixed));
}

TEST(StepMemory, KnowsThatAStepWasShortened) {
  const Bowl bowl(3.0, 0.0);  // full steps overshoot and swing up
  StepMemory memory;
  Eigen::VectorXd x = Eigen::VectorXd::Constant(kColumns, 3.0);
  for (const double share : {0.3, 1.0, 1.0, 1.0}) {
    const Eigen::VectorXd f = bowl.Step(x);
    memory.Stand(Numbers(f), Numbers(bowl.Gradient(x)), bowl.Length2(f));
    std::vector<double> step = Numbers(f);
    memory.Mix(step);
    x += share * Eigen::Map<const Eigen::VectorXd>(step.data(), kColumns);
    memory.Go(step, share);
  }
  EXPECT_LT(std::sqrt(bowl.Length2(bowl.Step(x))), 1e-6);
}

TEST(StepMemory, CanForget) {
  StepMemory memory;
  std::vector<double> mixed;
  memory.Stand({1.0}, {-1.0}, 1.0);
  memory.Go({1.0}, 1.0);
  memory.Stand({0.9}, {-0.9}, 0.81);
  EXPECT_TRUE(memory.Mix(mixed));
  memory.Forget();
  EXPECT_FALSE(memory.Mix(mixed));
}

}  // namespace
}  // namespace brachium
