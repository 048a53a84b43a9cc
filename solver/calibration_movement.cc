#include "solver/calibration_movement.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "problems/stillness.h"

namespace brachium {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

constexpr double kRest = 0.25;         // at either end of an interval [s]
constexpr double kMoving = 0.2;        // of the fastest rate: what counts for the axis
constexpr double kStillAtEnds = 0.35;  // of the fastest rate: what a rest may show
constexpr double kSharpest = 0.4;      // rms rate across the axis over rms rate along it
constexpr std::size_t kFewestSamples = 20;

// Mean rate in the longest rest, or zero.
Vector3d GyroBias(const Recording& recording) {
  const auto rests = DetectRests(recording, {});
  const auto longest = std::max_element(
      rests.begin(), rests.end(),
      [](const auto& a, const auto& b) { return a.end - a.start < b.end - b.start; });
  return longest == rests.end() ? Vector3d::Zero() : longest->mean_rate;
}

// The samples of an interval, the bias taken off the rates.
struct Stretch {
  std::vector<double> time;
  std::vector<Vector3d> rate, force;
  double fastest = 0.0;
};

Stretch StretchOf(const Recording& recording, const Vector3d& bias, const Interval& interval) {
  Stretch stretch;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    if (recording.time[i] < interval.start || recording.time[i] > interval.end) continue;
    stretch.time.push_back(recording.time[i]);
    stretch.rate.push_back(recording.gyr_S[i] - bias);
    stretch.force.push_back(recording.acc_S[i]);
    stretch.fastest = std::max(stretch.fastest, stretch.rate.back().norm());
  }
  return stretch;
}

struct End {
  Vector3d up = Vector3d::Zero();
  double rms_rate = 0.0;
};

End Between(const Stretch& stretch, double start, double end) {
  Vector3d force = Vector3d::Zero();
  double squares = 0.0, count = 0.0;
  for (std::size_t i = 0; i < stretch.time.size(); ++i) {
    if (stretch.time[i] < start || stretch.time[i] > end) continue;
    force += stretch.force[i];
    squares += stretch.rate[i].squaredNorm();
    ++count;
  }
  return {force.normalized(), std::sqrt(squares / std::max(count, 1.0))};
}

// What is wrong with a movement, or nothing.
std::string Measure(const Stretch& stretch, const CalibrationLimits& limits,
                    CalibrationMovement& movement) {
  if (stretch.time.size() < kFewestSamples) return "holds too few samples";
  Matrix3d moments = Matrix3d::Zero();
  for (const Vector3d& w : stretch.rate)
    if (w.norm() > kMoving * stretch.fastest) moments += w * w.transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(moments);
  movement.axis_S = solver.eigenvectors().col(2);
  movement.angle = 0.0;
  for (std::size_t i = 1; i < stretch.time.size(); ++i)
    movement.angle += 0.5 * (stretch.time[i] - stretch.time[i - 1]) *
                      (stretch.rate[i] + stretch.rate[i - 1]).dot(movement.axis_S);
  if (movement.angle < 0.0) {
    movement.angle = -movement.angle;
    movement.axis_S = -movement.axis_S;
  }
  if (movement.angle < limits.least_turn)
    return "turns the sensor by " + Degrees(movement.angle) + ", less than the " +
           Degrees(limits.least_turn) + " that are needed (one way, from a rest to a rest)";
  const Vector3d moment = solver.eigenvalues();
  if (std::sqrt((moment[0] + moment[1]) / moment[2]) > kSharpest)
    return "turns the sensor about more than one axis";
  const End before = Between(stretch, stretch.time.front(), stretch.time.front() + kRest);
  const End after = Between(stretch, stretch.time.back() - kRest, stretch.time.back());
  for (const auto& [end, name] : {std::pair{before, "begin"}, std::pair{after, "end"}})
    if (end.rms_rate > kStillAtEnds * stretch.fastest)
      return std::string("does not ") + name + " with a quarter of a second at rest";
  movement.up_before_S = before.up;
  movement.up_after_S = after.up;
  return "";
}

std::string Place(const Interval& interval) {
  char text[64];
  std::snprintf(text, sizeof text, " from %.1f to %.1f s ", interval.start, interval.end);
  return interval.label + text;
}

}  // namespace

std::vector<CalibrationMovement> MeasureMovements(const Recording& recording,
                                                  const std::vector<Interval>& intervals,
                                                  const std::string& label,
                                                  const CalibrationLimits& limits,
                                                  std::vector<std::string>* faults) {
  std::vector<CalibrationMovement> movements;
  const Vector3d bias = GyroBias(recording);
  for (const Interval& interval : intervals) {
    if (interval.label != label) continue;
    CalibrationMovement movement;
    const std::string fault = Measure(StretchOf(recording, bias, interval), limits, movement);
    if (fault.empty())
      movements.push_back(movement);
    else
      faults->push_back(Place(interval) + fault);
  }
  return movements;
}

MeanDirection Average(const std::vector<Vector3d>& directions) {
  MeanDirection average;
  for (const Vector3d& direction : directions) average.mean += direction;
  average.mean.normalize();
  double squares = 0.0;
  for (const Vector3d& direction : directions) {
    const double angle = AngleBetween(average.mean, direction);
    squares += angle * angle;
    average.worst = std::max(average.worst, angle);
  }
  average.count = static_cast<int>(directions.size());
  average.spread = directions.empty() ? 0.0 : std::sqrt(squares / average.count);
  return average;
}

double AngleBetween(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

std::string Degrees(double angle) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f deg", angle / kDegree);
  return text;
}

}  // namespace brachium
