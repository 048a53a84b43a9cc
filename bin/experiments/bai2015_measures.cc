// What Bai et al. (2015) read off their trials.
#include <algorithm>
#include <cmath>

#include "bin/experiments/bai2015.h"
#include "bin/experiments/points.h"
#include "bin/table.h"
#include "io/text.h"
#include "problems/joint_angles.h"

namespace brachium {
namespace {

constexpr double kWithin = 0.15;  // before the end of a peg's cycle, when the hand holds still [s]
const std::vector<std::string> kJoints = {"hand", "wrist", "elbow", "shoulder"};

// Rows up, backward, right, from the world; the person's heading is part of the truth.
Eigen::Matrix3d TrunkFromWorld(const SimulatedTrial& trial) {
  const double heading = trial.True("trunk.heading_deg").front() * kDegree;
  const Eigen::Vector3d forward(std::cos(heading), std::sin(heading), 0.0);
  Eigen::Matrix3d R;
  R << Eigen::RowVector3d::UnitZ(), -forward.transpose(),
      forward.cross(Eigen::Vector3d::UnitZ()).transpose();
  return R;
}

PegPlaces PegsOf(const SimulatedTrial& trial, const TrunkPath& hand) {
  PegPlaces places;
  for (std::size_t peg = 0; peg < places.size(); ++peg) {
    const std::string label = "cycle:peg_" + std::to_string(peg + 1);
    for (const Interval& cycle : trial.trial.observations.intervals) {
      if (cycle.label != label) continue;
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      double count = 0.0;
      for (std::size_t i = 0; i < hand.time.size(); ++i) {
        const auto place = hand.p.col(static_cast<Eigen::Index>(i));
        if (hand.time[i] < cycle.end - kWithin || hand.time[i] > cycle.end || !place.allFinite())
          continue;
        sum += place;
        ++count;
      }
      places[peg] = sum / count;
    }
  }
  return places;
}

Abduction AbductionOf(const SimulatedTrial& trial, const std::vector<double>& time,
                      const std::vector<Eigen::Quaterniond>& q_WU) {
  Abduction abduction{.time = time, .elevation = {}, .reached = {}};
  for (const auto& q : q_WU) abduction.elevation.push_back(ShoulderElevation(q) / kDegree);
  for (const Interval& cycle : trial.trial.observations.intervals) {
    if (cycle.label != "cycle:shoulder_abduction") continue;
    double most = 0.0;
    for (std::size_t i = 0; i < time.size(); ++i)
      if (cycle.start <= time[i] && time[i] <= cycle.end)
        most = std::fmax(most, abduction.elevation[i]);
    abduction.reached.push_back(most);
  }
  return abduction;
}

// How far a turn of a vector moves its end, mean over the instants, by trunk axis [m].
Eigen::Vector3d MeanShift(const SimulatedTrial& trial, Segment segment,
                          const Eigen::Vector3d& change_B) {
  const auto& attitudes = trial.trial.reference->q_VB.at(segment);
  const Eigen::Matrix3d R_TV = TrunkFromWorld(trial);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& q_VB : attitudes) sum += (R_TV * (q_VB * change_B)).cwiseAbs();
  return sum / static_cast<double>(attitudes.size());
}

}  // namespace

std::vector<int> BaiWeeks(bool quick) {
  if (quick) return {10};
  return {1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
}

std::string SessionName(int week) {
  return week == 0 ? "session_healthy" : "session_week_" + std::to_string(week);
}

TrunkPath TruePath(const SimulatedTrial& trial, const std::string& joint) {
  const Reference& reference = *trial.trial.reference;
  const auto& points = reference.p_V.at(joint);
  TrunkPath path{.time = reference.time,
                 .p = Eigen::Matrix3Xd(3, static_cast<Eigen::Index>(points.size()))};
  const Eigen::Matrix3d R_TV = TrunkFromWorld(trial);
  for (std::size_t i = 0; i < points.size(); ++i)
    path.p.col(static_cast<Eigen::Index>(i)) = R_TV * points[i];
  return path;
}

TrunkPath PathBy(const ExperimentResults& results, const std::string& trial,
                 const std::string& method, const std::string& joint) {
  const SimulatedTrial& truth = results.TrialOf(trial);
  std::vector<std::string> joints = {joint};
  if (truth.trial.observations.recordings.size() > 1)
    for (const std::string& other : kJoints)
      if (other != joint && truth.trial.reference->p_V.contains(other)) joints.push_back(other);
  const PointSeries points =
      AlignedPoints(results.EstimateOf(trial, method), *truth.trial.reference, joints).front();
  return {.time = points.time, .p = TrunkFromWorld(truth) * points.estimate};
}

PegPlaces TruePegs(const SimulatedTrial& trial) { return PegsOf(trial, TruePath(trial, "hand")); }

PegPlaces PegsBy(const ExperimentResults& results, const std::string& trial,
                 const std::string& method) {
  return PegsOf(results.TrialOf(trial), PathBy(results, trial, method, "hand"));
}

Abduction TrueAbduction(const SimulatedTrial& trial) {
  const Reference& reference = *trial.trial.reference;
  return AbductionOf(trial, reference.time, reference.q_VB.at(Segment::kUpperArm));
}

Abduction AbductionBy(const ExperimentResults& results, const std::string& trial,
                      const std::string& method) {
  const Estimate estimate = results.EstimateOf(trial, method);
  return AbductionOf(results.TrialOf(trial), estimate.time, estimate.q_WB.at(Segment::kUpperArm));
}

std::string SensitivityText(const SimulatedTrial& trial) {
  const auto centimetres = [](const Eigen::Vector3d& shift) {
    return std::vector<std::string>{Fixed(shift[0] * 100, 2), Fixed(shift[1] * 100, 2),
                                    Fixed(shift[2] * 100, 2)};
  };
  Table table({"error [cm], mean over the peg test", "x (up)", "y (back)", "z (right)"});
  const auto add = [&](const std::string& name, const std::vector<std::string>& cells) {
    table.Add({name, cells[0], cells[1], cells[2]});
  };
  add("upper arm 0.5 cm too long, paper", {"0.4", "0.1", "ignored"});
  add("the same here", centimetres(MeanShift(trial, Segment::kUpperArm, {0.0, -0.005, 0.0})));
  const double turned = 0.3 * std::sin(1.0 * kDegree);
  add("1 deg of pitch and yaw, 30 cm segment, paper", {"0.5", "0.01", "0.01"});
  add("1 deg about the forearm's flexion axis here",
      centimetres(MeanShift(trial, Segment::kForearm, {turned, 0.0, 0.0})));
  add("1 deg about its volar axis here",
      centimetres(MeanShift(trial, Segment::kForearm, {0.0, 0.0, turned})));
  return "\nSection II.E. Sensitivity of the chain, true attitudes\n" + table.Text();
}

}  // namespace brachium
