// The two axes of an elbow from how the sensors on either side of it turn against each other.
//
// With the flexion axis j1, fixed in the sensor A on the upper arm, and the pronation axis j2, fixed in
// the sensor B on the forearm, both unit vectors, flexion turns R_AB about j1 and pronation about j2.
// Neither changes j1ᵀ R_AB j2, which is the sine of adduction (z_U · y_F), so that the residual of
// elbow_adduction.h holds, here of axes:
//   r_i = (j1ᵀ R_AB,i j2 + s sin k_i) / cos k_i,    k_i = k0 + k1 (y_U · R_AB,i j2),
// s = +1 right, -1 left; y_U is l, from elbow to shoulder in A, made square to j1. Least squares over
//   Σ r_i²/(σ² (1 + g_i²) m) + (k0 - k)²/σ_k² + k1²/σ_k1² + (l · j1)²/σ_l² + |j2 × u|²/σ_u²,
// u from the forearm's sensor to the elbow in B, g = j1 · (y_U × R_AB j2).
// Instants    those between which the elbow turned by 2 deg: a rest counts once, however long it is.
// Start       j2 along u, j1 in turn in all directions square to l; the cheapest minimum that bends
//             counts: Σ j1 · (l × R_AB,i j2) > 0.
// Weight      σ is the elbow's departure from its hinge and, as much again, the turning of the skin under
//             the upper arm's sensor about the long axis, of which r takes the share g. Left out, that
//             turning draws the axes to where it shows least: 5 deg off on skin of 8 deg, with it 3.
//             The elbow departs from its hinge for a while, not anew at every instant: of N residuals
//             N/m count, m = 1 + 2 Σ ρ_n over their autocorrelation until it crosses zero. σ² from the
//             residuals, together with a handful (4) of the usual size, 5 deg.
// Covariance  of that least-squares problem.
// Blind to    j2 where the forearm is never turned, j1 where the elbow is never bent: there they stay
//             what anatomy says. j1 tilted along y_U looks like k1.
// Source      Laidig, Müller & Seel, Curr. Dir. Biomed. Eng. 3 (2017): the constraint in orientations,
//             of which Müller, Bégin, Schauer & Seel, IEEE J. Biomed. Health Inform. 21 (2017), take
//             the derivative, (ω_A - R_AB ω_B) · (j1 × R_AB j2) = 0. The changing carrying angle, the
//             weight and the anatomy are ours.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "problems/arm_model.h"

namespace brachium {

// What holds of an elbow before it moves: directions with an sd [rad], and the carrying angle.
struct HingeAnatomy {
  Side side = Side::kRight;
  Eigen::Vector3d to_shoulder_A = Eigen::Vector3d::UnitX();
  double to_shoulder_sd = 0.0;
  Eigen::Vector3d to_elbow_B = Eigen::Vector3d::UnitX();
  double to_elbow_sd = 0.0;
  ElbowModel elbow;
};

struct HingeAxes {
  Eigen::Vector3d j1_A = Eigen::Vector3d::UnitX();
  Eigen::Vector3d j2_B = Eigen::Vector3d::UnitX();
  Eigen::Matrix3d j1_covariance = Eigen::Matrix3d::Zero();  // of rank 2, in A
  Eigen::Matrix3d j2_covariance = Eigen::Matrix3d::Zero();  // the same in B
  double misfit = 0.0;  // rms of the elbow's departure from the hinge found [rad]
};

// `R_AB` are rotations in order of time; of their times nothing is asked. Requires two or more.
HingeAxes FindHingeAxes(const std::vector<Eigen::Matrix3d>& R_AB, const HingeAnatomy& anatomy);

}  // namespace brachium
