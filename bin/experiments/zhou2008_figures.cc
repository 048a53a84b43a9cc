// Figs 5 to 8 of Zhou et al. (2008). Positions of zhou lie metres away: they have a figure of their own.
#include <algorithm>
#include <array>
#include <cmath>

#include "bin/experiments/points.h"
#include "bin/experiments/zhou2008.h"
#include "io/plot/chart.h"
#include "io/plot/palette.h"
#include "problems/rotation.h"
#include "problems/sampling.h"

namespace brachium {
namespace {

constexpr double kShown = 40.0;  // of Figs 5 and 6 [s]

void AddLine(const std::string& name, const std::vector<double>& time,
             const std::vector<double>& values, double until, Chart& chart) {
  LineSeries line{.name = name,
                  .stroke = {.colour = SeriesColour(chart.lines.size()), .width = 1.2}};
  for (std::size_t i = 0; i < time.size() && time[i] <= until; ++i) {
    line.x.push_back(time[i]);
    line.y.push_back(values[i]);
  }
  chart.lines.push_back(line);
}

Chart ChartOver(const std::string& title, const std::string& label) {
  return {.title = title, .x = {.label = "time [s]"}, .y = {.label = label}};
}

// Turns about x, y and z, in that order about moving axes, of a segment since the start [deg].
std::array<std::vector<double>, 3> EulerAngles(const std::vector<Eigen::Quaterniond>& q_WB) {
  const auto first =
      std::find_if(q_WB.begin(), q_WB.end(), [](const auto& q) { return q.coeffs().allFinite(); });
  std::array<std::vector<double>, 3> angles;
  for (const Eigen::Quaterniond& q : q_WB) {
    const Eigen::Matrix3d R = (first->conjugate() * q).toRotationMatrix();
    angles[0].push_back(std::atan2(-R(1, 2), R(2, 2)) / kDegree);
    angles[1].push_back(std::asin(std::clamp(R(0, 2), -1.0, 1.0)) / kDegree);
    angles[2].push_back(std::atan2(-R(0, 1), R(0, 0)) / kDegree);
  }
  return angles;
}

std::vector<Chart> EulerCharts(const ExperimentResults& results, const std::string& title,
                               const std::string& trial, Segment segment, double until) {
  const Reference& reference = *results.TrialOf(trial).trial.reference;
  std::vector<Chart> charts;
  const auto truth = EulerAngles(reference.q_VB.at(segment));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    charts.push_back(
        ChartOver(title + ", " + std::string(Name(segment)) + ": Euler angle (" + "xyz"[axis] + ")",
                  "angle [deg]"));
    AddLine("truth", reference.time, truth[axis], until, charts.back());
  }
  for (const std::string method : {"zhou", "smoother"}) {
    const Estimate estimate = results.EstimateOf(trial, method);
    const auto angles = EulerAngles(estimate.q_WB.at(segment));
    for (std::size_t axis = 0; axis < 3; ++axis)
      AddLine(method, estimate.time, angles[axis], until, charts[axis]);
  }
  return charts;
}

std::vector<double> Axis(const Eigen::Matrix3Xd& points, int axis) {
  const Eigen::RowVectorXd row = points.row(axis);
  return {row.data(), row.data() + row.size()};
}

std::vector<Chart> PositionCharts(const ExperimentResults& results, const std::string& title,
                                  const std::string& trial, const std::string& from, double until) {
  const std::vector<std::string> joints = {"wrist", "elbow"};
  const auto points = AlignedPoints(results.EstimateOf(trial, "smoother"),
                                    *results.TrialOf(trial).trial.reference, joints, from);
  std::vector<Chart> charts;
  for (std::size_t j = 0; j < joints.size(); ++j)
    for (int axis = 0; axis < 3; ++axis) {
      charts.push_back(
          ChartOver(title + ", " + joints[j] + ": position (" + "xyz"[axis] + ")", "[m]"));
      AddLine("truth", points[j].time, Axis(points[j].reference, axis), until, charts.back());
      AddLine("smoother", points[j].time, Axis(points[j].estimate, axis), until, charts.back());
    }
  return charts;
}

Chart RotationChart(const ExperimentResults& results) {
  const std::string trial = "forearm_rotation";
  Chart chart = ChartOver("Fig. 8, " + trial + ": the turn about the forearm", "pronation [deg]");
  for (const std::string& method : kZhouMethods) {
    const AngleSeries series =
        AnglesOf(results.EstimateOf(trial, method), *results.TrialOf(trial).trial.reference,
                 "forearm_pronation");
    const auto degrees = [](const Series& angle) {
      const Eigen::RowVectorXd row = angle.row(0) / kDegree;
      return std::vector<double>(row.data(), row.data() + row.size());
    };
    if (chart.lines.empty()) AddLine("truth", series.time, degrees(series.reference), 1e9, chart);
    AddLine(method, series.time, degrees(series.estimate), 1e9, chart);
  }
  return chart;
}

Chart DriftChart(const ExperimentResults& results, const std::string& trial) {
  Chart chart = ChartOver(trial + ": distance of the wrist from where it was", "error [m]");
  chart.y.logarithmic = true;
  for (const std::string& method : kZhouMethods) {
    const Evaluation& evaluation = results.PairOf(trial, method).evaluation;
    AddLine(method, evaluation.time, evaluation.positions.at("wrist").distance, 1e9, chart);
  }
  return chart;
}

void Append(const std::vector<Chart>& more, std::vector<Chart>& charts) {
  charts.insert(charts.end(), more.begin(), more.end());
}

}  // namespace

std::map<std::string, std::string> ZhouFigures(const ExperimentResults& results, bool quick) {
  const ChartSize small{.width = 860.0, .height = 200.0};
  std::vector<Chart> five = EulerCharts(results, "Fig. 5", "rectangle", Segment::kForearm, kShown);
  Append(EulerCharts(results, "Fig. 5", "rectangle", Segment::kUpperArm, kShown), five);
  std::vector<Chart> drift;
  for (const char* trial : {"rectangle", "reach", "shrug"})
    drift.push_back(DriftChart(results, trial));
  if (!quick)
    for (const char* trial : {"reach_5min", "shrug_5min"})
      drift.push_back(DriftChart(results, trial));
  return {{"figure_5.svg", DrawCharts(five, small)},
          {"figure_6.svg",
           DrawCharts(PositionCharts(results, "Fig. 6", "rectangle", "", kShown), small)},
          {"figure_7.svg",
           DrawCharts(PositionCharts(results, "Fig. 7", "reach", "shoulder", 1e9), small)},
          {"figure_8.svg", DrawCharts({RotationChart(results)})},
          {"drift.svg", DrawCharts(drift)}};
}

}  // namespace brachium
