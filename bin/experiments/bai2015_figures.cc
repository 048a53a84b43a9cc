// Figs 8 to 12 of Bai et al. (2015).
#include <algorithm>

#include "bin/experiments/bai2015.h"
#include "io/plot/chart.h"
#include "io/plot/palette.h"
#include "problems/statistics.h"

namespace brachium {
namespace {

const std::array<std::string, 3> kAxes = {"x (up)", "y (back)", "z (right)"};

Chart ChartOver(const std::string& title, const std::string& label) {
  return {.title = title, .x = {.label = "time [s]"}, .y = {.label = label}};
}

void AddLine(const std::string& name, const std::vector<double>& time,
             const std::vector<double>& values, Chart& chart) {
  chart.lines.push_back({.name = name,
                         .x = time,
                         .y = values,
                         .stroke = {.colour = SeriesColour(chart.lines.size()), .width = 1.2}});
}

std::vector<double> Axis(const TrunkPath& path, int axis) {
  const Eigen::RowVectorXd row = path.p.row(axis);
  return {row.data(), row.data() + row.size()};
}

// One axis of a joint, the truth and by each method [m].
Chart PathChart(const ExperimentResults& results, const std::string& title,
                const std::string& trial, const std::string& joint, int axis,
                const std::vector<std::string>& methods) {
  Chart chart = ChartOver(title + ": " + joint + ", " + kAxes[static_cast<std::size_t>(axis)],
                          "position [m]");
  const TrunkPath truth = TruePath(results.TrialOf(trial), joint);
  AddLine("truth", truth.time, Axis(truth, axis), chart);
  for (const std::string& method : methods) {
    const TrunkPath path = PathBy(results, trial, method, joint);
    AddLine(method, path.time, Axis(path, axis), chart);
  }
  return chart;
}

std::vector<Chart> PathCharts(const ExperimentResults& results, const std::string& title,
                              const std::string& trial, const std::string& joint,
                              const std::vector<std::string>& methods) {
  std::vector<Chart> charts;
  for (int axis = 0; axis < 3; ++axis)
    charts.push_back(PathChart(results, title, trial, joint, axis, methods));
  return charts;
}

void Append(const std::vector<Chart>& more, std::vector<Chart>& charts) {
  charts.insert(charts.end(), more.begin(), more.end());
}

// Least to greatest with the mean, as in the paper, and quartiles with the median.
Chart WeeklyChart(const ExperimentResults& results, bool quick, bool quartiles) {
  Chart chart{.title = quartiles ? "Fig. 9 a: quartiles and median, whiskers to least and greatest"
                                 : "Fig. 9 a: box from least to greatest, line at the mean",
              .y = {.label = "abduction [deg]", .from_zero = true}};
  const std::vector<std::string> names = {"truth", "bai_kinematic", "smoother"};
  for (std::size_t m = 0; m < names.size(); ++m)
    chart.boxes.push_back({.name = names[m], .colour = SeriesColour(m), .width = 0.2});
  std::vector<int> weeks = BaiWeeks(quick);
  weeks.push_back(0);
  for (const int week : weeks) {
    const std::string session = SessionName(week);
    const auto group = static_cast<double>(chart.x.categories.size());
    chart.x.categories.push_back(week == 0 ? "healthy" : std::to_string(week));
    for (std::size_t m = 0; m < names.size(); ++m) {
      const std::vector<double> reached = (m == 0 ? TrueAbduction(results.TrialOf(session))
                                                  : AbductionBy(results, session, names[m]))
                                              .reached;
      const double low = Quantile(reached, 0.0), high = Quantile(reached, 1.0);
      double mean = 0.0;
      for (const double value : reached) mean += value / static_cast<double>(reached.size());
      const double place = group + 0.25 * (static_cast<double>(m) - 1.0);
      if (quartiles)
        chart.boxes[m].boxes.push_back({place, low, Quantile(reached, 0.25), Quantile(reached, 0.5),
                                        Quantile(reached, 0.75), high});
      else
        chart.boxes[m].boxes.push_back({place, low, low, mean, high, high});
    }
  }
  return chart;
}

std::vector<Chart> SessionCharts(const ExperimentResults& results, bool quick) {
  std::vector<Chart> charts;
  for (const int week : quick ? std::vector<int>{10, 0} : std::vector<int>{1, 4, 10, 0}) {
    const std::string session = SessionName(week);
    charts.push_back(ChartOver("Fig. 9 b, " + session, "elevation [deg]"));
    const Abduction truth = TrueAbduction(results.TrialOf(session));
    AddLine("truth", truth.time, truth.elevation, charts.back());
    for (const std::string& method : kKinematicMethods) {
      const Abduction by = AbductionBy(results, session, method);
      AddLine(method, by.time, by.elevation, charts.back());
    }
  }
  return charts;
}

void AddEpochs(const Estimate& estimate, Chart& chart) {
  for (const Epoch& epoch : estimate.diagnostics.epochs) {
    chart.rules.push_back({.value = epoch.start, .upright = true, .stroke = {.colour = "#d55e00"}});
    chart.rules.push_back({.value = epoch.end, .upright = true, .stroke = {.colour = "#009e73"}});
  }
}

// From one sample to the next [m/s].
Chart VelocityChart(const ExperimentResults& results, const std::string& method) {
  const TrunkPath path = PathBy(results, "pegs_hand", method, "hand");
  Chart chart = ChartOver("Fig. 11 a: velocity to the right by " + method, "[m/s]");
  std::vector<double> velocity(path.time.size(), Statistics::kUnknown);
  for (std::size_t i = 1; i < path.time.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    velocity[i] = (path.p(2, at) - path.p(2, at - 1)) / (path.time[i] - path.time[i - 1]);
  }
  AddLine("", path.time, velocity, chart);
  AddEpochs(results.EstimateOf("pegs_hand", "bai_dead_reckoning_zupt"), chart);
  return chart;
}

Chart EnergyChart(const ExperimentResults& results) {
  const Recording& hand = results.TrialOf("pegs_hand").trial.observations.recordings.front();
  Chart chart = ChartOver("Fig. 11 a: the gyroscope's energy; red: start, green: end of an epoch",
                          "[rad^2/s^2]");
  std::vector<double> energy;
  for (const Eigen::Vector3d& gyr : hand.gyr_S) energy.push_back(gyr.squaredNorm());
  AddLine("", hand.time, energy, chart);
  AddEpochs(results.EstimateOf("pegs_hand", "bai_dead_reckoning_zupt"), chart);
  return chart;
}

}  // namespace

std::map<std::string, std::string> BaiFigures(const ExperimentResults& results, bool quick) {
  const ChartSize small{.width = 860.0, .height = 220.0};
  std::vector<Chart> eight =
      PathCharts(results, "Fig. 8 a", "pegs_two_sensors", "wrist", kKinematicMethods);
  Append(
      PathCharts(results, "Fig. 8 b, goniometer", "goniometer_swing", "wrist", kKinematicMethods),
      eight);
  std::vector<Chart> nine = {WeeklyChart(results, quick, false), WeeklyChart(results, quick, true)};
  Append(SessionCharts(results, quick), nine);
  std::vector<Chart> ten =
      PathCharts(results, "Fig. 10 a", "pegs_healthy", "hand", kKinematicMethods);
  Append(PathCharts(results, "Fig. 10 b", "pegs_healthy", "shoulder", kKinematicMethods), ten);
  std::vector<Chart> eleven = {VelocityChart(results, "bai_dead_reckoning"), EnergyChart(results),
                               VelocityChart(results, "bai_dead_reckoning_zupt")};
  eleven.push_back(PathChart(results, "Fig. 11 b", "pegs_hand", "hand", 2, {"bai_dead_reckoning"}));
  eleven.push_back(PathChart(results, "Fig. 11 c", "pegs_hand", "hand", 2,
                             {"bai_dead_reckoning_zupt", "smoother"}));
  std::vector<Chart> twelve = {
      PathChart(results, "Fig. 12 a, healthy", "pegs_healthy", "hand", 2, kKinematicMethods)};
  if (!quick)
    twelve.push_back(
        PathChart(results, "Fig. 12 b, patient", "pegs_patient", "hand", 2, kKinematicMethods));
  return {{"figure_8.svg", DrawCharts(eight, small)},
          {"figure_9.svg", DrawCharts(nine, small)},
          {"figure_10.svg", DrawCharts(ten, small)},
          {"figure_11.svg", DrawCharts(eleven, small)},
          {"figure_12.svg", DrawCharts(twelve, small)}};
}

}  // namespace brachium
