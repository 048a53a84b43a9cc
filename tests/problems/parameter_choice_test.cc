#include "problems/parameter_choice.h"

#include <gtest/gtest.h>

#include <cmath>

#include "problems/sweep_table.h"

namespace brachium {
namespace {

const double kNone = std::nan("");

TEST(ParameterChoice, TakesThePointOfTheLeastMean) {
  const Eigen::MatrixXd errors{{1.0, 2.0, 9.0}, {9.0, 3.0, 1.0}};
  const ParameterChoice choice = ChooseParameters(errors);
  EXPECT_EQ(choice.overall, 1);
  EXPECT_DOUBLE_EQ(choice.overall_error, 2.5);
  EXPECT_EQ(choice.best, (std::vector<ParameterChoice::Point>{0, 2}));
}

TEST(ParameterChoice, JudgesATrialByThePointThatTheOthersChose) {
  const Eigen::MatrixXd errors{{1.0, 2.0, 9.0}, {9.0, 3.0, 1.0}};
  const ParameterChoice choice = ChooseParameters(errors);
  EXPECT_EQ(choice.by_others, (std::vector<ParameterChoice::Point>{2, 0}));
  EXPECT_DOUBLE_EQ(choice.others_error, 9.0);
}

TEST(ParameterChoice, DoesNotLetATrialChooseForItself) {
  Eigen::MatrixXd errors{{5.0, 6.0}, {5.0, 6.0}, {5.0, 6.0}};
  const ParameterChoice before = ChooseParameters(errors);
  errors(1, 1) = 0.0;
  EXPECT_EQ(ChooseParameters(errors).by_others[1], before.by_others[1]);
}

TEST(ParameterChoice, LeavesOutAPointThatATrialLacksAndATrialWithoutResults) {
  const Eigen::MatrixXd errors{{0.1, 2.0}, {kNone, 3.0}, {kNone, kNone}};
  const ParameterChoice choice = ChooseParameters(errors);
  EXPECT_EQ(choice.overall, 1);
  EXPECT_DOUBLE_EQ(choice.overall_error, 2.5);
  EXPECT_FALSE(choice.best[2]);
  EXPECT_FALSE(choice.by_others[2]);
}

TEST(ParameterChoice, ChoosesNothingFromNothingAndExpectsNothingFromOneTrial) {
  EXPECT_FALSE(ChooseParameters(Eigen::MatrixXd::Constant(2, 2, kNone)).overall);
  EXPECT_FALSE(ChooseParameters(Eigen::MatrixXd(0, 0)).overall);
  const ParameterChoice one = ChooseParameters(Eigen::MatrixXd{{2.0, 1.0}});
  EXPECT_EQ(one.overall, 1);
  EXPECT_TRUE(std::isnan(one.others_error));
}

TEST(ParameterChoice, TakesTheFirstOfEqualPoints) {
  EXPECT_EQ(ChooseParameters(Eigen::MatrixXd{{1.0, 1.0}, {2.0, 2.0}}).overall, 0);
}

TEST(SweptMethod, PointsAlongAnOptionDifferInNoOther) {
  SweptMethod method;
  method.points = {{"1", "a"}, {"1", "b"}, {"2", "a"}, {"2", "b"}};
  EXPECT_EQ(PointsAlong(method, 0, 1), (std::vector<std::size_t>{1, 3}));
  EXPECT_EQ(PointsAlong(method, 1, 2), (std::vector<std::size_t>{2, 3}));
}

}  // namespace
}  // namespace brachium
