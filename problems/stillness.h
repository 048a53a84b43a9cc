// When a sensor is at rest, and how certain that is.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "problems/imu.h"

namespace brachium {

// Tolerances of the motion that a rest may still hold: breathing and tremor of a person who keeps
// still, or the rocking of a foot or hand that stops for a moment between fast movements.
struct StillnessOptions {
  double window_s = 0.2;          // over which stillness is judged
  double edge_s = 0.05;           // over which the edges of a rest are judged
  double shortest_s = 0.15;       // a rest is at least as long
  double rate_deg_s = 1.0;        // rms of the angular rate about its bias
  double force = 0.06;            // rms of the specific force about its mean [m/s²]
  double share_of_motion = 0.06;  // or this share of the recording's own rms, where that is more
};

struct RestInterval {
  double start = 0.0, end = 0.0;  // [s]
  double probability = 1.0;       // that it is a rest
  double slack = 1.0;  // how many times the tolerance of a person who keeps still it needed, >= 1
  Eigen::Vector3d mean_rate = Eigen::Vector3d::Zero();   // sensor axes [rad/s]
  Eigen::Vector3d mean_force = Eigen::Vector3d::Zero();  // sensor axes [m/s²]
  double sway = 0.0;  // rms of the detrended integrated rate, per axis [rad]
};

// Rests of one sensor, in order, not overlapping. The statistic over a window of samples is
//   T = mean|w - b|²/σ_w² + mean|f - mean f|²/σ_f²,   probability 1/(1 + exp(T - 2));
// the bias b is the mean rate of the quietest second, and zero where no second is quiet enough to
// be told from slow motion by the sensor's own bias. Windows that are still as a whole take along
// the movement that ends or begins in them: a rest is cut back until T over its first and last
// `edge_s` is at most four times that of its stillest window. A rest whose mean force is not gravity
// (by the accelerometer's bias, 1 % of scale and the tolerance) is the turning point of a movement.
// After Skog et al., IEEE T-BME 57 (2010), who show that this generalised likelihood ratio test
// beats either signal alone.
std::vector<RestInterval> DetectRests(const Recording& recording, const StillnessOptions& options);

// The part of a rest inside [start, end], with its own means and sway; a probability of 0 where
// fewer than three samples fall inside.
RestInterval PartOfRest(const Recording& recording, const RestInterval& rest, double start,
                        double end);

}  // namespace brachium
