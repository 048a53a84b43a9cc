// Dead reckoning of a sensor, and what is known of it where it stands: Bai et al. (2015), section
// II.C.2.
//
//   a = R f - (0, 0, g)      (4)     v = ∫ a dt      (5)     p = ∫ v dt      (6)
// by the trapezoidal rule between samples. With zero-velocity updates, v = 0 outside of epochs, and
// within an epoch from t1 to t2 the straight line between the errors at its ends is taken off,
//   v'(t) = v(t) - v(t1) - (v(t2) - v(t1)) (t - t1)/(t2 - t1):
// a constant error of the acceleration leaves no trace. An epoch without a rest after it (at the end
// of the recording) keeps its drift.
// Loses what the sensor moves between epochs: distances come out too short.
#pragma once

#include <vector>

#include "problems/estimate.h"

namespace brachium {

// v at each time, from rest at the first [m/s].
std::vector<Eigen::Vector3d> IntegrateOnce(const std::vector<double>& time,
                                           const std::vector<Eigen::Vector3d>& rate);

// Takes the drift off, in place. Epochs in order, not overlapping.
void UpdateZeroVelocity(const std::vector<double>& time, const std::vector<Epoch>& epochs,
                        std::vector<Eigen::Vector3d>& v_W);

}  // namespace brachium
