#include "io/report/page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "io/report/html.h"
#include "problems/arm_model.h"
#include "tests/support/reported.h"
#include "tests/support/unpacked.h"

namespace brachium {
namespace {

using nlohmann::ordered_json;
using testing::AllOf, testing::HasSubstr, testing::Not;

constexpr PageFiles kFiles{.style = "p{}",
                           .packed = "1;",
                           .charts = "2;",
                           .scene = "s;",
                           .replay = "3;",
                           .plot_style = "u{}",
                           .plot_script = "0;",
                           .plot_licence = "as is"};

Report ReportOf(std::vector<ReportedEstimate> estimates) {
  return {.version = "1.2.3", .estimates = std::move(estimates)};
}

std::string HtmlOf(ReportedEstimate reported) {
  return PageOf(ReportOf({std::move(reported)}), kFiles).html;
}

ordered_json DataOf(const std::string& html, const std::string& id) {
  const std::string mark = "id=\"" + id + "\">";
  const std::size_t begin = html.find(mark) + mark.size();
  return ordered_json::parse(html.substr(begin, html.find("</script>", begin) - begin));
}

TEST(ReportPage, LetsNothingInFromElsewhereAndNoScriptButItsOwn) {
  const std::string html = HtmlOf(BendingArm());
  EXPECT_THAT(html, AllOf(HasSubstr("default-src 'none'"),
                          HasSubstr("script-src " + PolicyHash("0;\n1;2;s;3;") + "\""),
                          HasSubstr("style-src " + PolicyHash("u{}\np{}") + ";")));
  EXPECT_THAT(html, AllOf(Not(HasSubstr("src=\"http")), Not(HasSubstr("style=\""))));
}

TEST(ReportPage, IsTheSameForTheSameReport) { EXPECT_EQ(HtmlOf(KnownArm()), HtmlOf(KnownArm())); }

TEST(ReportPage, TakesNoNameForMarkup) {
  const std::string evil = "</script><img src=x onerror=alert(1)>";
  ReportedEstimate reported = BendingArm(evil);
  reported.run.findings.warnings = {evil};
  reported.estimate.diagnostics.notes = {evil};
  reported.estimate.diagnostics.residuals = {{evil, 3, 1.0}};
  reported.reference_note = evil;
  const ReportPage page = PageOf(ReportOf({reported, reported}), kFiles);
  EXPECT_THAT(page.html, AllOf(Not(HasSubstr("<img")), HasSubstr("&lt;img src=x")));
  for (const auto& [name, svg] : page.figures) {
    EXPECT_EQ(name.find_first_of("/<>\\"), name.npos) << name;
    EXPECT_THAT(svg, Not(HasSubstr("<img")));
  }
}

TEST(ReportPage, ShowsTheAnglesOfTheEstimate) {
  const ReportedEstimate reported = KnownArm();
  const ordered_json charts = DataOf(HtmlOf(reported), "charts-0");
  ASSERT_EQ(charts[0]["title"], "elbow flexion");
  const ordered_json& line = charts[0]["lines"][0];
  const std::vector<double> time = UnpackedTimes(charts[0]["xs"][line["x"].get<std::size_t>()]);
  const std::vector<double> angle = Unpacked(line["y"]);
  ASSERT_EQ(angle.size(), 200u);
  EXPECT_NEAR(time[199], 1.99, 1e-5);
  EXPECT_NEAR(angle[10], (0.5 - 0.4 * std::cos(0.3)) / kDegree, 0.005);
  EXPECT_TRUE(std::isnan(angle[100]));
  const std::vector<double> high = Unpacked(charts[0]["bands"][0]["high"]);
  EXPECT_NEAR(high[10] - angle[10], 1.96 * 0.01 / kDegree, 0.01);
  EXPECT_EQ(charts[0]["lines"][1]["name"], "reference");
  EXPECT_EQ(charts[0]["spans"], ordered_json::parse("[[0.2, 0.4]]"));
}

TEST(ReportPage, ReplaysTheArmAndItsReference) {
  const ordered_json replay = DataOf(HtmlOf(KnownArm()), "replay-0");
  EXPECT_EQ(replay["joints"], ordered_json({"elbow", "shoulder", "wrist"}));
  EXPECT_EQ(replay["bones"].size(), 2u);
  const std::vector<double> points = Unpacked(replay["estimate"]["p"]);
  ASSERT_EQ(points.size(), 200u * 9u);
  EXPECT_NEAR(points[1], 0.2, 1e-4);
  EXPECT_NEAR(Unpacked(replay["deviation"]["sd"])[2], 0.03, 1e-5);
  const ordered_json& flexion = replay["angles"][0];
  EXPECT_NEAR(Unpacked(flexion["value"])[10] - Unpacked(flexion["reference"])[10], 1.0, 0.011);
  EXPECT_TRUE(std::isnan(Unpacked(flexion["value"])[100]));
}

TEST(ReportPage, DrawsAnArmWithoutPositionsWithAnAdultsLengths) {
  const ordered_json replay = DataOf(HtmlOf(BendingArm()), "replay-0");
  EXPECT_THAT(replay["notes"].dump(), HasSubstr("adult's lengths"));
  EXPECT_TRUE(replay["deviation"].is_null());
  const std::vector<double> points = Unpacked(replay["estimate"]["p"]);  // elbow, shoulder, wrist
  EXPECT_NEAR(std::hypot(points[0], points[1], points[2]), 0.30, 1e-3);
}

TEST(ReportPage, DrawsAHandFromTheWrist) {
  ReportedEstimate reported = KnownArm();
  Estimate& estimate = reported.estimate;
  estimate.q_WB[Segment::kHand] = estimate.q_WB[Segment::kForearm];
  estimate.p_W["hand"] = estimate.p_W["wrist"];
  const ordered_json replay = DataOf(HtmlOf(reported), "replay-0");
  EXPECT_EQ(replay["joints"], ordered_json({"elbow", "hand", "shoulder", "wrist"}));
  EXPECT_EQ(replay["bones"][2], ordered_json::parse("[3, 1, 2]"));
}

TEST(ReportPage, GetsByWithoutReferenceDeviationsOrArm) {
  ReportedEstimate alone{.name = "walk, smoother", .label = "smoother"};
  alone.run.trial = "walk";
  alone.estimate.method = "smoother";
  for (int i = 0; i < 50; ++i) {
    alone.estimate.time.push_back(0.01 * i);
    alone.estimate.q_WB[Segment::kForearm].push_back(Eigen::Quaterniond::Identity());
    alone.estimate.p_W["forearm"].emplace_back(0.02 * i, 0.0, 1.0);
  }
  alone.reference_note = "The trial has no reference.";
  const std::string html = HtmlOf(alone);
  EXPECT_THAT(html, AllOf(HasSubstr("The trial has no reference."),
                          HasSubstr("forearm inclination"), Not(HasSubstr("nan"))));
  const ordered_json replay = DataOf(html, "replay-0");
  EXPECT_EQ(replay["bones"], ordered_json::parse("[[0, 0, 0]]"));
  EXPECT_FALSE(replay.contains("reference"));
}

TEST(ReportPage, GetsByWithoutAnyMotion) {
  ReportedEstimate still = BendingArm();
  still.estimate.q_WB[Segment::kUpperArm].assign(200, Eigen::Quaterniond(NAN, NAN, NAN, NAN));
  still.estimate.q_WB.erase(Segment::kForearm);
  still.evaluation.reset();
  still.reference.reset();
  EXPECT_THAT(HtmlOf(still), Not(HasSubstr("nan")));
}

TEST(ReportPage, PutsEstimatesOfOneTrialSideBySide) {
  ReportedEstimate other = BendingArm();
  other.label = "luinge";
  other.name = "drinking, luinge";
  const ReportPage page = PageOf(ReportOf({KnownArm(), other}), kFiles);
  EXPECT_THAT(page.html, AllOf(HasSubstr("Side by side"), HasSubstr("Rmse of joint angles")));
  EXPECT_TRUE(page.figures.contains("drinking-overlaid_angles.svg"));
  EXPECT_TRUE(page.figures.contains("comparison-errors.svg"));
  EXPECT_TRUE(page.figures.contains("drinking-luinge-joint_angles.svg"));
}

TEST(ReportPage, SaysThatAnEstimateIsNotToBeTrusted) {
  ReportedEstimate reported = BendingArm();
  reported.estimate.diagnostics.converged = false;
  EXPECT_THAT(HtmlOf(reported), HasSubstr("Not to be trusted"));
}

TEST(ReportPage, MarksResidualsAboveTheirBounds) {
  const ReportPage page = PageOf(ReportOf({BendingArm()}), kFiles);
  const std::string& svg = page.figures.at("drinking-smoother-residuals.svg");
  EXPECT_THAT(svg, AllOf(HasSubstr("above: claims too much"), HasSubstr("gyroscope/forearm")));
}

TEST(ReportPage, HasPicturesWhereTheBuildHadNoPlotter) {
  const ReportPage page =
      PageOf(ReportOf({BendingArm()}), {.style = "p{}", .charts = "2;", .replay = "3;"});
  EXPECT_THAT(page.html, AllOf(HasSubstr("Built without uPlot"), HasSubstr("<svg"),
                               Not(HasSubstr("data-charts=")), Not(HasSubstr("id=\"charts-"))));
}

TEST(ReportPage, ShowsSweepsAndComparisonsOfFoldersWhateverTheyLack) {
  const ReportedFolder sweep{
      .kind = ReportedFolder::Kind::kSweep,
      .name = "sigma",
      .json = ordered_json::parse(
          R"({"tasks": 4, "figure": "f", "methods": [{"method": "luinge", "overall": {"s": 0.1}}]})"),
      .pictures = {{"sweep_lines.svg", "<svg onload=\"alert(1)\"/>"}}};
  const ReportedFolder comparison{.name = "all",
                                  .json = ordered_json::parse(
                                      R"({"trials": ["t"], "methods": ["a", "b"], "pairs": [
              {"trial": "t", "method": "a", "outcome": "done", "trusted": false,
               "evaluation": {"relative": {"forearm_in_upper_arm": {"rmse_deg": 1.25}}}},
              {"trial": "t", "method": "b", "outcome": "failed", "reason": "why <not>"}, 7]})")};
  const std::string html = PageOf({.folders = {sweep, comparison}}, kFiles).html;
  EXPECT_THAT(html, AllOf(HasSubstr("s = 0.1"), HasSubstr("<td>1.25 *</td><td>failed</td>"),
                          HasSubstr("why &lt;not&gt;"), Not(HasSubstr("onload")),
                          HasSubstr("data:image/svg+xml;base64,PHN2Zy")));
}

TEST(ReportPage, StaysSmallForALongTrial) {
  ReportedEstimate reported = BendingArm();
  Estimate& estimate = reported.estimate;
  for (int i = 200; i < 60000; ++i) {
    const auto k = static_cast<std::size_t>(i % 60);
    estimate.time.push_back(0.01 * i);
    for (auto& [segment, q_WB] : estimate.q_WB) q_WB.push_back(Eigen::Quaterniond(q_WB[k]));
  }
  EXPECT_LT(HtmlOf(reported).size(), 4'000'000u);
  const ordered_json replay = DataOf(HtmlOf(reported), "replay-0");
  EXPECT_THAT(replay["notes"].dump(), HasSubstr("one sample of"));
}

}  // namespace
}  // namespace brachium
