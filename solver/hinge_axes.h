// The two axes of an elbow from how the sensors on either side of it turn against each other.
//
// With the flexion axis j1, fixed in the sensor A on the upper arm, and the pronation axis j2, fixed in
// the sensor B on the forearm, both unit vectors,
//   e_i = j1ᵀ R_AB,i j2 = sin β,      β the carrying angle but for a sign: constant,
// for flexion turns R_AB about j1 and pronation about j2. Its derivative is the constraint on angular
// rates (ω_A - R_AB ω_B) · (j1 × R_AB j2) = 0; as an integral it needs no rates and forgets nothing.
// Bilinear in the axes: with m = j1 ⊗ j2 and r_i the nine entries of R_AB,i,
//   Σ w_i (e_i - mean e)² + ν (mean e)² = mᵀ K m,    ν = (σ/12 deg)², the prior of β about zero,
// so that K (9 x 9) holds all that the motion says. For a given j1 the best j2 is the eigenvector of
// the least eigenvalue of a 3 x 3 matrix, and the other way round: searched from directions all over
// the sphere, no guess being needed. w_i are Huber weights, estimated along.
// Covariance  adduction is not new at every sample: correlated over τ = 1.5 s, N samples of period h
//             count as N h / (2τ); its sd is the rms of e, at least 2 deg.
// Blind to    the signs of both axes; j2 where the forearm is never turned, j1 where the elbow is never
//             bent: their sd becomes large.
// Source      Müller, Bégin, Schauer & Seel, IEEE J. Biomed. Health Inform. 21 (2017), for the
//             constraint; Laidig, Müller & Seel, Curr. Dir. Biomed. Eng. 3 (2017), in orientations.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace brachium {

struct HingeAxes {
  Eigen::Vector3d j1_A = Eigen::Vector3d::UnitX();  // either sign
  Eigen::Vector3d j2_B = Eigen::Vector3d::UnitX();  // either sign
  double j1_sd = 0.0;                               // in the direction that is known least [rad]
  double j2_sd = 0.0;                               // the same
  double misfit = 0.0;                              // rms of e about its mean [rad]
  double next_misfit = 0.0;  // of the next best pair of axes; infinite where there is none
};

// `R_AB` are rotations at instants `period` [s] apart. Requires two or more.
HingeAxes FindHingeAxes(const std::vector<Eigen::Matrix3d>& R_AB, double period);

}  // namespace brachium
