#include "io/comparison_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "io/comparison_figures.h"
#include "io/output_folder.h"
#include "problems/arm_model.h"
#include "problems/rotation.h"
#include "tests/support/smooth_motion.h"
#include "tests/support/temporary_folder.h"

namespace brachium {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

// A forearm that is that many degrees off about its own axis.
Evaluation OffBy(double degrees) {
  Estimate estimate;
  estimate.time = EvenTimes(0.0, 0.01, 500);
  estimate.q_WB[Segment::kUpperArm] =
      Sampled(estimate.time, [](double t) { return SmoothRotation(t); });
  estimate.q_WB[Segment::kForearm] =
      Sampled(estimate.time, [](double t) { return SmoothRotation(t, 1.0); });
  Reference reference;
  reference.time = estimate.time;
  reference.q_VB = estimate.q_WB;
  reference.clock_offset = 0.0;
  for (auto& q : estimate.q_WB[Segment::kForearm])
    q = q * Exp(Eigen::Vector3d(0, degrees * kDegree, 0));
  return Evaluate(estimate, reference);
}

Comparison Example() {
  using Outcome = ComparedPair::Outcome;
  Comparison comparison{.trials = {"eating", "peg, left"}, .methods = {"a", "b"}, .pairs = {}};
  comparison.pairs = {
      {.trial = "eating", .method = "a", .evaluation = OffBy(2.0)},
      {.trial = "eating",
       .method = "b",
       .reason = "not converged",
       .trusted = false,
       .evaluation = OffBy(4.0)},
      {.trial = "peg, left", .method = "a", .outcome = Outcome::kFailed},
      {.trial = "peg, left", .method = "b", .outcome = Outcome::kRefused, .reason = "says \"no\""}};
  return comparison;
}

std::vector<std::string> LinesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = text.find('\n', start);
    lines.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return lines;
}

TEST(ComparisonCsv, HasARowPerTrialAndMethod) {
  const auto lines = LinesOf(ComparisonCsv(Example()));
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_THAT(lines[0], StartsWith("trial,method,outcome,trusted,reason,"));
  EXPECT_THAT(lines[1], StartsWith("eating,a,done,1,,"));
  EXPECT_THAT(lines[2], StartsWith("eating,b,done,0,not converged,"));
  EXPECT_THAT(lines[3], StartsWith("\"peg, left\",a,failed,,,"));
  EXPECT_THAT(lines[4], StartsWith("\"peg, left\",b,refused,,\"says \"\"no\"\"\","));
}

TEST(ComparisonCsv, HasAsManyCellsInEachRow) {
  const auto lines = LinesOf(ComparisonCsv(Example()));
  const auto commas = [](const std::string& line) {
    return std::count(line.begin(), line.end(), ',');
  };
  EXPECT_EQ(commas(lines[1]), commas(lines[0]));
  EXPECT_EQ(commas(lines[2]), commas(lines[0]));
  EXPECT_EQ(commas(lines[3]), commas(lines[0]) + 1);
}

TEST(ComparisonCsv, NamesFiguresByTheirPath) {
  const auto lines = LinesOf(ComparisonCsv(Example()));
  EXPECT_THAT(lines[0], HasSubstr(",relative.forearm_in_upper_arm.rmse_deg,"));
  EXPECT_THAT(lines[0], HasSubstr(",joint_angles.forearm_pronation.limits_of_agreement.upper_deg"));
  EXPECT_THAT(lines[0], Not(HasSubstr(".raw.")));
}

TEST(ComparisonJson, TellsWhatIsNotThereByItsAbsence) {
  const auto json = nlohmann::json::parse(ComparisonJson(Example(), {}));
  EXPECT_NEAR(
      json["pairs"][1]["evaluation"]["relative"]["forearm_in_upper_arm"]["rmse_deg"].get<double>(),
      4.0, 1e-9);
  EXPECT_EQ(json["pairs"][1]["trusted"], false);
  EXPECT_FALSE(json["pairs"][3].contains("evaluation"));
  EXPECT_EQ(json["pairs"][3]["reason"], "says \"no\"");
}

TEST(ComparisonFigures, ShowWhatThereIs) {
  const auto figures = ComparisonFigures(Example());
  ASSERT_EQ(figures.size(), 2u);
  EXPECT_THAT(figures.at("errors.svg"), HasSubstr(">eating<"));
  EXPECT_THAT(figures.at("error_over_time_eating.svg"), HasSubstr("<polyline"));
  EXPECT_EQ(ComparisonFigures(Example()), figures);
}

TEST(ComparisonFolder, IsNotReplacedByOneOfOtherFlagsUnlessToldSo) {
  const TemporaryFolder folder;
  const std::string place = folder.File("comparison");
  ComparisonInfo info;
  info.flags = {{"methods", "a,b"}};
  WriteComparison(place, Example(), info, ComparisonFigures(Example()), false);
  EXPECT_NO_THROW(CheckComparable(place, info.flags, false));
  EXPECT_NO_THROW(WriteComparison(place, Example(), info, ComparisonFigures(Example()), false));
  EXPECT_THROW(CheckComparable(place, {{"methods", "a"}}, false), OutputExists);
  EXPECT_NO_THROW(CheckComparable(place, {{"methods", "a"}}, true));
}

TEST(ComparisonFolder, IsNotMadeOfAnotherKindOfFolder) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.File("estimate"));
  std::filesystem::create_directories(folder.File("begun/estimates/one/a"));
  folder.Write("estimate/summary.json", "{}");
  EXPECT_THROW(CheckComparable(folder.File("estimate"), {{"methods", "a"}}, true), OutputExists);
  EXPECT_NO_THROW(CheckComparable(folder.File("begun"), {{"methods", "a"}}, false));
  EXPECT_NO_THROW(CheckComparable(folder.File("absent"), {{"methods", "a"}}, false));
}

}  // namespace
}  // namespace brachium
