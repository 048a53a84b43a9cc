// Figs 3 to 6 of Luinge et al. (2007).
#include <algorithm>

#include "bin/experiments/elbow_trace.h"
#include "bin/experiments/luinge2007.h"
#include "io/plot/chart.h"
#include "io/plot/palette.h"
#include "solver/calibrate.h"

namespace brachium {
namespace {

const Recording& UpperArm(const Observations& observations) {
  return *std::find_if(
      observations.recordings.begin(), observations.recordings.end(),
      [](const Recording& recording) { return recording.segment == Segment::kUpperArm; });
}

// How the calibration movements of a trial say that the upper arm's sensor is turned.
Eigen::Quaterniond CalibratedUpperArm(const Observations& observations) {
  for (const SegmentCalibration& segment : Calibrate(observations, {}).segments)
    if (segment.segment == Segment::kUpperArm) return segment.mounting.q_BS;
  return Eigen::Quaterniond::Identity();
}

// Angular velocity from the first endorotation to the end of the first exorotation, turned by q.
Chart TurningChart(const std::string& title, const Observations& observations,
                   const Eigen::Quaterniond& q) {
  const auto movement = [&](const std::string& label) {
    return *std::find_if(observations.intervals.begin(), observations.intervals.end(),
                         [&](const Interval& interval) { return interval.label == label; });
  };
  const double start = movement("calibration:upper_arm_endorotation").start,
               end = movement("calibration:upper_arm_exorotation").end;
  Chart chart{
      .title = title, .x = {.label = "time [s]"}, .y = {.label = "angular velocity [rad/s]"}};
  const Recording& arm = UpperArm(observations);
  for (const int axis : {0, 1, 2}) {
    LineSeries line{.name = std::string(1, "xyz"[axis]),
                    .stroke = {.colour = SeriesColour(static_cast<std::size_t>(axis))}};
    for (std::size_t i = 0; i < arm.size(); ++i) {
      if (arm.time[i] < start || arm.time[i] > end) continue;
      line.x.push_back(arm.time[i]);
      line.y.push_back((q * arm.gyr_S[i])[axis]);
    }
    chart.lines.push_back(line);
  }
  return chart;
}

std::vector<Chart> TurningCharts(const ExperimentResults& results) {
  const Observations& observations = results.TrialOf(kCalibrationTrial).trial.observations;
  return {TurningChart("Fig. 3: endo- and exorotation of the upper arm, in the sensor's axes",
                       observations, Eigen::Quaterniond::Identity()),
          TurningChart("in the segment's axes, by calibration", observations,
                       CalibratedUpperArm(observations))};
}

Chart ErrorChart(const ExperimentResults& results, const std::string& trial) {
  Chart chart{.title = "Fig. 4, " + trial + ": error of the forearm in the upper arm",
              .x = {.label = "time [s]"},
              .y = {.label = "error [deg]", .from_zero = true}};
  const std::pair<std::string, std::string> lines[] = {
      {kFree + kOn, "without constraint, no biases"},
      {SweptName(kTied + kOn, kPaperSigma), "with constraint, no biases"},
      {kFree, "without, biases from rests"},
      {SweptName(kTied, kPaperSigma), "with, biases from rests"},
      {SweptName(kSmoother, DefaultSigmaDeg()), "smoother"}};
  for (const auto& [name, label] : lines) {
    const Evaluation& evaluation = results.PairOf(trial, name).evaluation;
    chart.lines.push_back({.name = label,
                           .x = evaluation.time,
                           .y = InDegrees(evaluation.relative.at(0).angle),
                           .stroke = {.colour = SeriesColour(chart.lines.size()), .width = 1.2}});
  }
  return chart;
}

Chart ObservabilityChart(const ExperimentResults& results, const std::string& trial) {
  const ElbowTrace trace = TraceOf(*results.TrialOf(trial).trial.reference);
  Chart chart{.title = trial + ": how much of the relative heading the adduction shows",
              .x = {.label = "time [s]"},
              .y = {.label = "n_z", .limits = Range{-1.0, 1.0}}};
  chart.lines.push_back({.x = trace.time, .y = trace.n_z, .stroke = {.width = 1.2}});
  chart.rules.push_back({.value = 0.0});
  return chart;
}

Chart AdductionChart(const std::string& title, const ElbowTrace& trace) {
  Chart chart{.title = title,
              .x = {.label = "time [s]"},
              .y = {.label = "adduction [deg]", .limits = Range{-60.0, 60.0}}};
  chart.lines.push_back(
      {.x = trace.time, .y = InDegrees(trace.adduction), .stroke = {.width = 1.0}});
  return chart;
}

std::vector<Chart> AdductionCharts(const ExperimentResults& results) {
  const std::string trial = "morning", tied = SweptName(kTied + kOn, kPaperSigma);
  return {
      AdductionChart("Fig. 5, morning: adduction by the reference",
                     TraceOf(*results.TrialOf(trial).trial.reference)),
      AdductionChart("by the filter, sqrt(R) = 10 deg", TraceOf(results.EstimateOf(trial, tied))),
      AdductionChart("by the smoother",
                     TraceOf(results.EstimateOf(trial, SweptName(kSmoother, DefaultSigmaDeg()))))};
}

}  // namespace

std::map<std::string, std::string> LuingeFigures(const ExperimentResults& results,
                                                 const LuingeSweeps& sweeps, bool quick) {
  std::vector<Chart> errors;
  for (const std::string& routine : Routines(quick)) {
    errors.push_back(ErrorChart(results, routine));
    errors.push_back(ObservabilityChart(results, routine));
  }
  std::vector<Chart> panels;
  for (const auto& [what, swept] : {std::pair{"filter without biases", &sweeps.on},
                                    std::pair{"filter with biases from rests", &sweeps.rests},
                                    std::pair{"smoother", &sweeps.smoother}})
    for (const Chart& panel : SweepCharts(what, *swept)) panels.push_back(panel);
  return {{"figure_3.svg", DrawCharts(TurningCharts(results))},
          {"figure_4.svg", DrawCharts(errors)},
          {"figure_5.svg", DrawCharts(AdductionCharts(results))},
          {"figure_6.svg", DrawCharts(panels)}};
}

}  // namespace brachium
