// The two axes of an elbow from how the sensors on either side of it turn against each other.
//
// With the flexion axis j1, fixed in the sensor A on the upper arm, and the pronation axis j2, fixed in
// the sensor B on the forearm, both unit vectors,
//   e_i = j1ᵀ R_AB,i j2 = sin β,      β the carrying angle but for a sign: constant,
// for flexion turns R_AB about j1 and pronation about j2. Its derivative is the constraint on angular
// rates (ω_A - R_AB ω_B) · (j1 × R_AB j2) = 0; as an integral it needs no rates and forgets nothing.
// Bilinear in the axes: with m = j1 ⊗ j2 and r_i the nine entries of R_AB,i,
//   Σ w_i (e_i - mean e)² = mᵀ K m,
// so that K (9 x 9) holds all that the motion says. For a given j1 the best j2 is the eigenvector of
// the least eigenvalue of a 3 x 3 matrix, and the other way round: searched from directions all over
// the sphere, no guess being needed. Huber weights w_i are estimated along.
// What anatomy adds, weakly, is quadratic too, but for the expected β, which waits for the signs and
// enters in a last Gauss-Newton descent:
//   (mean e - sin β)²/σ_β²,   (j1 · l)²/σ_l²,   |j2 × u|²/σ_u²,
// l from elbow to shoulder in A, u from sensor to elbow in B.
// Signs       j2 along u; j1 such that bending is positive: Σ j1 · (l × R_AB,i j2) > 0.
// Covariance  of that last descent. Adduction is not new at every sample: correlated over τ = 1 s, N
//             samples of period h count as N h / (2τ); its sd is the rms of e, at least 8 deg, as on
//             people (Luinge et al., J. Biomech. 40 (2007)). Rests are left out.
// Blind to    j2 where the forearm is never turned, j1 where the elbow is never bent: their sd stays
//             what anatomy gives.
// Source      Müller, Bégin, Schauer & Seel, IEEE J. Biomed. Health Inform. 21 (2017), for the
//             constraint; Laidig, Müller & Seel, Curr. Dir. Biomed. Eng. 3 (2017), in orientations.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace brachium {

// Unit vectors and angles that hold of any elbow, each with an sd [rad].
struct HingeAnatomy {
  Eigen::Vector3d to_shoulder_A;
  double to_shoulder_sd;
  Eigen::Vector3d to_elbow_B;
  double to_elbow_sd;
  double beta;
  double beta_sd;
};

struct HingeAxes {
  Eigen::Vector3d j1_A = Eigen::Vector3d::UnitX();
  Eigen::Vector3d j2_B = Eigen::Vector3d::UnitX();
  double j1_sd = 0.0;        // in the direction that is known least [rad]
  double j2_sd = 0.0;        // the same
  double misfit = 0.0;       // rms of e about its mean [rad]
  double next_misfit = 0.0;  // of the next best pair of axes; infinite where there is none
};

// `R_AB` are rotations at instants `period` [s] apart. Requires two or more.
HingeAxes FindHingeAxes(const std::vector<Eigen::Matrix3d>& R_AB, double period,
                        const HingeAnatomy& anatomy);

}  // namespace brachium
