// Zhou, Stone, Hu & Harris, Med. Eng. Phys. 30 (2008), section 3: designed paths, reaching, shrugging,
// forearm rotation.
//
// From the paper: a circle of radius 0.1 m and a rectangle of 0.2 m x 0.14 m for two minutes; reaches
// to 100 deg of flexion, shrugs of 8 cm and forearm rotation for 20 s with the left arm; 25 Hz; means
// over the three axes and over cycles, after a rigid alignment without scale. Ours, fixed before any
// method ran: all errors that are usual on people (HonestErrors) with MTx noise; one simulated person
// for four; the last three also for 5 minutes. No trial holds movements with a still shoulder, so zhou
// shares the drift by -1/2.
#include "bin/experiments/zhou2008.h"

#include <cmath>

#include "bin/experiments/experiments.h"
#include "bin/experiments/points.h"
#include "bin/table.h"
#include "io/text.h"
#include "problems/designed_path.h"

namespace brachium {
namespace {

// One row of a table of the paper: mean, SD, RMS, correlation, p.
struct Printed {
  std::string mean, sd, rms, correlation, p;
};

struct Movement {
  std::string name, scenario;
  Side side;
  double seconds;  // without the rests
};

std::vector<Movement> Movements(bool quick) {
  if (quick)
    return {{"rectangle", "rectangle", Side::kRight, 40},
            {"reach", "reach", Side::kLeft, 20},
            {"shrug", "shrug", Side::kLeft, 20},
            {"forearm_rotation", "forearm_rotation", Side::kLeft, 20}};
  return {{"circle", "circle", Side::kRight, 120},
          {"rectangle", "rectangle", Side::kRight, 120},
          {"reach", "reach", Side::kLeft, 20},
          {"shrug", "shrug", Side::kLeft, 20},
          {"forearm_rotation", "forearm_rotation", Side::kLeft, 20},
          {"reach_5min", "reach", Side::kLeft, 300},
          {"shrug_5min", "shrug", Side::kLeft, 300},
          {"forearm_rotation_5min", "forearm_rotation", Side::kLeft, 300}};
}

std::string Metres(double value) { return Fixed(value, std::abs(value) < 9.9995 ? 3 : 0); }
std::string Degrees(double value) { return Fixed(value, 2); }

std::string Optional(const std::optional<double>& value) { return value ? Fixed(*value, 2) : ""; }

std::vector<std::string> RowOf(const std::string& name, const CycleAnalysis& analysis, double unit,
                               std::string (*text)(double)) {
  return {name,
          text(analysis.mean_bias / unit),
          text(analysis.mean_sd / unit),
          text(analysis.mean_rmse / unit),
          Optional(analysis.mean_correlation),
          Optional(analysis.p),
          text(analysis.mean_rmse_whole / unit)};
}

Table TableFor(const std::string& what) {
  return Table({what, "Mean", "S.D.", "RMS", "Correlation", "p-Value", "RMS 3-D"});
}

void AddPrinted(const std::string& name, const Printed& row, Table& table) {
  table.Add({name, row.mean, row.sd, row.rms, row.correlation, row.p});
}

// Joints of one trial by every method, beside what the paper printed of them.
void AddPoints(const ExperimentResults& results, const std::string& trial,
               const std::vector<std::string>& joints, const std::string& from,
               const std::map<std::string, Printed>& printed, Table& table) {
  const Trial& truth = results.TrialOf(trial).trial;
  std::vector<std::vector<PointSeries>> points;
  for (const std::string& method : kZhouMethods)
    points.push_back(
        AlignedPoints(results.EstimateOf(trial, method), *truth.reference, joints, from));
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const std::string what = trial + ", " + joints[j];
    if (printed.contains(joints[j])) AddPrinted(what + ", paper", printed.at(joints[j]), table);
    for (std::size_t m = 0; m < kZhouMethods.size(); ++m) {
      const PointSeries& series = points[m][j];
      const auto cycles = CyclesOf(truth, series.time, series.reference.row(2));
      table.Add(RowOf(what + ", " + kZhouMethods[m],
                      AnalyseCycles(series.time, series.estimate, series.reference, cycles), 1.0,
                      Metres));
    }
  }
}

void AddAngle(const ExperimentResults& results, const std::string& trial, const std::string& angle,
              Table& table) {
  const Trial& truth = results.TrialOf(trial).trial;
  for (const std::string& method : kZhouMethods) {
    const AngleSeries series = AnglesOf(results.EstimateOf(trial, method), *truth.reference, angle);
    const auto cycles = CyclesOf(truth, series.time, series.reference);
    table.Add(RowOf(trial + ", " + method,
                    AnalyseCycles(series.time, series.estimate, series.reference, cycles), kDegree,
                    Degrees));
  }
}

bool Has(bool quick, const std::string& trial) {
  for (const Movement& movement : Movements(quick))
    if (movement.name == trial) return true;
  return false;
}

// The wrist from the first cycle to the last.
Eigen::Matrix3Xd Drawn(const PointSeries& wrist, const std::vector<Interval>& cycles) {
  Eigen::Matrix3Xd drawn(3, static_cast<Eigen::Index>(wrist.time.size()));
  Eigen::Index count = 0;
  for (std::size_t i = 0; i < wrist.time.size(); ++i)
    if (cycles.front().start <= wrist.time[i] && wrist.time[i] <= cycles.back().end)
      drawn.col(count++) = wrist.estimate.col(static_cast<Eigen::Index>(i));
  return drawn.leftCols(count);
}

std::string Table1(const ExperimentResults& results, bool quick) {
  struct Path {
    std::string trial;
    DesignedPath path;
    Printed printed;
  };
  const std::vector<Path> paths = {
      {"circle", DesignedPath::Circle(0.1), {"0.006", "0.014", "0.015", "0.96", "0.48"}},
      {"rectangle",
       DesignedPath::Rectangle(0.2, 0.14),
       {"0.004", "0.011", "0.012", "0.98", "0.56"}}};
  Table table = TableFor("wrist [m]"), shapes({"wrist, closest point of the path [m]", "RMS 3-D"});
  for (const Path& path : paths) {
    if (!Has(quick, path.trial)) continue;
    AddPoints(results, path.trial, {"wrist"}, "", {{"wrist", path.printed}}, table);
    const Trial& truth = results.TrialOf(path.trial).trial;
    for (const std::string& method : kZhouMethods) {
      const auto wrist =
          AlignedPoints(results.EstimateOf(path.trial, method), *truth.reference, {"wrist"})
              .front();
      const auto cycles = CyclesOf(truth, wrist.time, wrist.reference.row(0));
      const PathErrors errors = CompareWithPath(Drawn(wrist, cycles), path.path);
      shapes.Add({path.trial + ", " + method, Metres(errors.distance.rmse)});
    }
  }
  return "Table 1. The wrist in the designed paths, over time against where it was\n" +
         table.Text() + "and against the shape, whatever the time\n" + shapes.Text();
}

std::string Tables2And3(const ExperimentResults& results, bool quick) {
  const std::map<std::string, Printed> printed = {
      {"wrist", {"0.003", "0.006", "0.007", "0.98", "0.31"}},
      {"elbow", {"0.006", "0.009", "0.010", "0.97", "0.43"}}};
  Table points = TableFor("from the shoulder [m]"), angles = TableFor("elbow flexion [deg]");
  AddPoints(results, "reach", {"wrist", "elbow"}, "shoulder", printed, points);
  AddPrinted("reach, paper", {"0.41", "2.34", "2.41", "0.98", "0.44"}, angles);
  AddAngle(results, "reach", "elbow_flexion", angles);
  if (!quick) {
    AddPoints(results, "reach_5min", {"wrist", "elbow"}, "shoulder", {}, points);
    AddAngle(results, "reach_5min", "elbow_flexion", angles);
  }
  return "\nTable 2. Reaching: wrist and elbow\n" + points.Text() +
         "\nTable 3. Reaching: elbow flexion\n" + angles.Text();
}

std::string Table4(const ExperimentResults& results, bool quick) {
  const std::map<std::string, Printed> printed = {
      {"wrist", {"-0.003", "0.006", "0.007", "0.98", "0.63"}},
      {"elbow", {"-0.004", "0.006", "0.005", "0.98", "0.43"}},
      {"shoulder", {"-0.002", "0.005", "0.004", "0.96", "0.46"}}};
  const std::vector<std::string> joints = {"wrist", "elbow", "shoulder"};
  Table points = TableFor("in the room [m]"), relative = TableFor("from the shoulder [m]");
  AddPoints(results, "shrug", joints, "", printed, points);
  AddPoints(results, "shrug", {"wrist", "elbow"}, "shoulder", {}, relative);
  if (!quick) {
    AddPoints(results, "shrug_5min", joints, "", {}, points);
    AddPoints(results, "shrug_5min", {"wrist", "elbow"}, "shoulder", {}, relative);
  }
  return "\nTable 4. Shrugging: the three joints (in the paper two RMS are below their S.D., which "
         "cannot be)\n" +
         points.Text() + relative.Text();
}

std::string Table5(const ExperimentResults& results, bool quick) {
  Table table = TableFor("pronation [deg]");
  AddPrinted("forearm_rotation, paper", {"0.06", "4.82", "4.83", "0.94", "0.35"}, table);
  AddAngle(results, "forearm_rotation", "forearm_pronation", table);
  if (!quick) AddAngle(results, "forearm_rotation_5min", "forearm_pronation", table);
  return "\nTable 5. Forearm rotation\n" + table.Text();
}

}  // namespace

ExperimentPlan PlanZhou2008(bool quick) {
  ExperimentPlan plan;
  for (const Movement& movement : Movements(quick)) {
    ExperimentTrial trial;
    trial.name = movement.name;
    trial.errors = HonestErrors(MtxNoise());
    trial.movement.name = movement.scenario;
    trial.movement.side = movement.side;
    trial.movement.duration = kRestAtStart + movement.seconds + kRestAtEnd;
    trial.errors.rate = 25.0;
    plan.trials.push_back(trial);
    plan.runs.push_back({movement.name, "zhou", ZhouOptions{}});
    plan.runs.push_back({movement.name, "zhou_no_highpass", ZhouOptions{.zhou_highpass_hz = 0.0}});
    plan.runs.push_back({movement.name, "smoother", SmootherOptions{}});
  }
  return plan;
}

ExperimentReport ReportZhou2008(const ExperimentResults& results, bool quick) {
  return {.text = Table1(results, quick) + Tables2And3(results, quick) + Table4(results, quick) +
                  Table5(results, quick),
          .figures = ZhouFigures(results, quick)};
}

}  // namespace brachium
