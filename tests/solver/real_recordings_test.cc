// The smoother on recordings of rigs and a walking foot, where they are at hand.
#include <gtest/gtest.h>

#include <filesystem>

#include "io/trial_folder.h"
#include "problems/evaluation.h"
#include "solver/batch_smoother.h"

namespace brachium {
namespace {

namespace fs = std::filesystem;

const fs::path kTrials = fs::path(BRACHIUM_SOURCE_DIR) / "../shared/data/trials";

Evaluation Evaluated(const std::string& name) {
  const Trial trial = ReadTrial((kTrials / name).string()).trial;
  const Estimate estimate = BatchSmoother({}).Run(trial.observations);
  EXPECT_TRUE(estimate.diagnostics.converged) << estimate.diagnostics.termination;
  return Evaluate(estimate, trial.reference.value());
}

struct Rig {
  std::string name;
  double tolerance_deg;  // rmse of the relative orientation, one constant removed on each side
};

class RealRig : public testing::TestWithParam<Rig> {};

TEST_P(RealRig, IsFollowedWithinItsTolerance) {
  if (!fs::is_directory(kTrials / GetParam().name)) GTEST_SKIP() << "no recordings at hand";
  const Evaluation evaluation = Evaluated(GetParam().name);
  ASSERT_EQ(evaluation.relative.size(), 1u);
  const Statistics& rotation = evaluation.relative[0].orientation.aligned.rotation;
  EXPECT_GT(rotation.used, 1000u);
  EXPECT_LT(rotation.rmse / kDegree, GetParam().tolerance_deg);
}

INSTANTIATE_TEST_SUITE_P(, RealRig,
                         testing::Values(Rig{"diodem_trial1_rigid_seg1_seg2", 0.7},
                                         Rig{"diodem_trial1_rigid_seg2_seg3", 0.5},
                                         Rig{"diodem_trial1_rigid_seg3_seg4", 0.4},
                                         Rig{"diodem_trial1_nonrigid_seg1_seg2", 3.0},
                                         Rig{"jhu_test01_upper_middle", 0.6}),
                         [](const auto& rig) { return rig.param.name; });

TEST(RealFoot, IsDeadReckonedWithinAShareOfItsPath) {
  if (!fs::is_directory(kTrials / "foot_dead_reckoning")) GTEST_SKIP() << "no recordings at hand";
  const Evaluation evaluation = Evaluated("foot_dead_reckoning");
  const PositionEvaluation& hand = evaluation.positions.at("hand");
  ASSERT_GT(hand.path_length, 10.0);
  EXPECT_LT(hand.aligned.horizontal.rmse, 0.015 * hand.path_length);
  EXPECT_LT(hand.final_horizontal, 0.015 * hand.path_length);
}

}  // namespace
}  // namespace brachium
