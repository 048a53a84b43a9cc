// The elbow as a measurement, after Luinge, Veltink & Baten (2007), section 2.2: a healthy elbow has
// next to no adduction, so what the estimate shows of it is an error of the relative heading.
//
// The paper's axes x (lateral), y (proximal), z (dorsal) are Z, Y, -X of the ISB; its x_U is z_U
// here, on both sides of the body. All vectors in W, θ rotates the estimate to the truth:
//   R = Exp(θ) R^                                                      (7), see below
//   z_U · y_F = sin β^,   β the paper's adduction with its sign put right (6)
//   sin β^ - sin β = nᵀθ_F - nᵀθ_U,   n = z_U × y_F                    (8)
//   H = [nᵀ, -nᵀ] for {θ_F; θ_U}                                       (9)
//   K = Q Hᵀ (H Q Hᵀ + σ²)⁻¹,  Q = [Q_F, Q_FU; Q_UF, Q_U]              (11), (12)
// Errata of the printed equations:
//   (6)  the angle between x_U and y_F less 90 deg is minus x_U · y_F, not plus;
//   (7)  θ is said to turn the truth to the estimate; (7) and (8) hold for the opposite;
//   (9)  is printed as [nᵀ, nᵀ], against (8): it turns both segments together, so that a relative
//        heading error stays for ever while the common heading spins;
//   (12) is printed as diag(Q_U, Q_F) beside a state {θ_F; θ_U}. The cross-covariance, dropped in
//        the paper at every step, is kept here: without it the same adduction is learned anew each
//        time.
// Blind to  a turn common to both; flexion; pronation. The relative heading changes sin β by n_z:
//           nothing where the hanging arm is straight, or where the flexion axis is vertical.
#pragma once

#include <Eigen/Geometry>

namespace brachium {

struct PredictedAdduction {
  double sine = 0.0;                // z_U · y_F = sin β^
  Eigen::Matrix<double, 1, 6> H_W;  // of {θ_F; θ_U} in W
};

PredictedAdduction PredictAdduction(const Eigen::Quaterniond& q_WF, const Eigen::Quaterniond& q_WU);

}  // namespace brachium
