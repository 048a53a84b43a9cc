// Short simulated trials, and what tests ask of an estimate of them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <vector>

#include "problems/estimate.h"
#include "problems/rotation.h"
#include "problems/sampling.h"
#include "problems/simulation/simulate.h"

namespace brachium {

using AttitudesBySegment = std::map<Segment, std::vector<Eigen::Quaterniond>>;

inline ScenarioOptions BriskScenario(double duration) {
  return {.name = "daily_brisk", .seed = 3, .duration = duration};
}

// Whole-arm reaches at everyday speed [s].
inline Trial Brisk(double duration, const SimulationOptions& options = {}) {
  return Simulate(MakeScenario(BriskScenario(duration)), options).trial;
}

// The samples of a recording from one instant to another [s].
inline Recording Cut(const Recording& whole, double start, double end) {
  Recording part = whole;
  part.time.clear();
  part.gyr_S.clear();
  part.acc_S.clear();
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (whole.time[i] < start || whole.time[i] > end) continue;
    part.time.push_back(whole.time[i]);
    part.gyr_S.push_back(whole.gyr_S[i]);
    part.acc_S.push_back(whole.acc_S[i]);
  }
  return part;
}

// A recording whose samples between two instants were lost [s].
inline Recording Without(const Recording& whole, double from, double to) {
  Recording left = Cut(whole, whole.time.front(), from);
  const Recording after = Cut(whole, to, whole.time.back());
  left.time.insert(left.time.end(), after.time.begin(), after.time.end());
  left.gyr_S.insert(left.gyr_S.end(), after.gyr_S.begin(), after.gyr_S.end());
  left.acc_S.insert(left.acc_S.end(), after.acc_S.begin(), after.acc_S.end());
  return left;
}

inline std::vector<Eigen::Quaterniond> ForearmInUpperArm(const AttitudesBySegment& q_WB) {
  const auto& q_WU = q_WB.at(Segment::kUpperArm);
  const auto& q_WF = q_WB.at(Segment::kForearm);
  std::vector<Eigen::Quaterniond> q_UF;
  for (std::size_t i = 0; i < q_WU.size(); ++i) q_UF.push_back(q_WU[i].conjugate() * q_WF[i]);
  return q_UF;
}

// The angles between two series of rotations [rad]; every instant must have both.
inline std::vector<double> Angles(const std::vector<Eigen::Quaterniond>& a,
                                  const std::vector<Eigen::Quaterniond>& b) {
  EXPECT_EQ(a.size(), b.size());
  std::vector<double> angles;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    angles.push_back(Log<double>(a[i].conjugate() * b[i]).norm());
  return angles;
}

inline double Rms(const std::vector<double>& values) {
  double squares = 0.0;
  for (const double value : values) squares += value * value;
  return std::sqrt(squares / static_cast<double>(values.size()));
}

inline double Worst(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

inline double RmsAngle(const std::vector<Eigen::Quaterniond>& a,
                       const std::vector<Eigen::Quaterniond>& b) {
  return Rms(Angles(a, b));
}

// Rms angle between the estimated and the true attitude of the forearm in the upper arm [rad].
inline double RelativeError(const Estimate& estimate, const Reference& reference) {
  return RmsAngle(ForearmInUpperArm(estimate.q_WB), ForearmInUpperArm(reference.q_VB));
}

}  // namespace brachium
