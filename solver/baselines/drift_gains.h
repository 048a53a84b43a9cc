// How much of the disagreement of two drifting positions belongs to one of them: the λ of Zhou,
// Stone, Hu & Harris (2008), Eqs (8), (9), learned while the shoulder is known to keep still.
//
//   P_s = A - λ S,  A the shoulder from the upper arm's sensor, S the forearm sensor's elbow less
//   the upper arm sensor's; all from where they were at the start, world axes, λ diagonal.
// (9) asks for ∂A/∂t = λ ∂S/∂t + constant, that is, over each repetition and axis
//   A(t) = c0 + c1 t + λ S(t),
// a regression with a polynomial of the first degree in time beside S; c0 and c1 are each
// repetition's own (they take up the velocity with which it is entered), λ is common:
//   λ = Σ x_rᵀ y_r / Σ x_rᵀ x_r,   x_r, y_r = S, A less their straight lines in repetition r.
// Its uncertainty comes from how the repetitions differ, not from the samples, whose errors go
// together:  sd² = n/(n-1) Σ (x_rᵀ y_r - λ x_rᵀ x_r)² / (Σ x_rᵀ x_r)²,  interval by Student's t, n-1.
// Errata: (9) is called a Karush-Kuhn-Tucker condition and derives by the time; what remains of it
//   is this regression. Equal and independent drifts of the two sensors would give λ = -1/2, the
//   mean of both, and 1/√2 of the drift: that is the gain without a calibration.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "problems/observations.h"

namespace brachium {

inline constexpr double kEqualDriftGain = -0.5;

struct DriftGains {
  Eigen::Vector3d value = Eigen::Vector3d::Constant(kEqualDriftGain);  // of the world axes
  Eigen::Vector3d sd = Eigen::Vector3d::Zero();
  Eigen::Vector3d half_width_95 = Eigen::Vector3d::Zero();  // of the 95 % confidence interval
  int repetitions = 0;
};

// Series at times in s, NaN where unknown. Each of the intervals is cut into equal parts so that
// there are `repetitions` or a few more in all. Absent where fewer than three parts have ten samples
// or where S does not vary along some axis.
std::optional<DriftGains> LearnDriftGains(const std::vector<double>& time,
                                          const std::vector<Eigen::Vector3d>& A,
                                          const std::vector<Eigen::Vector3d>& S,
                                          const std::vector<Interval>& intervals, int repetitions);

}  // namespace brachium
