// A sensor's rotation on its segment from one pose that everybody knows: the calibration of Bai et
// al. (2015), section II.F.2, with the arm hanging still.
//
//   R_align = R_gs(0)ᵀ R_expected(ψ),   segment in the world = R_gs(t) R_align               (9)
// with g the maker's world and ψ the heading that the person faces. Here R_align = R_SB, so
//   q_BS = R_expected(ψ)ᵀ q_gs(0).
// Expected, in ISB axes: all segments' Y up, X forward, but the forearm pronated as the start pose
// says (90 deg where it says nothing: thumbs forward) and the hand with it; elbow straight.
//
// Erratum: (9) is printed as R_sensor ⊗ R_expected, which is no rotation of the sensor on anything;
//   the text's Euler angles (0, -90, ψ) are those of Bai's axes (x proximal, y backward).
// Blind to   a sensor's turn about the long axis where ψ is wrong, and what each of several sensors'
//            worlds has its own heading: hence maker's orientations only, which share north.
#pragma once

#include <string>

#include "problems/observations.h"

namespace brachium {

// R_expected(ψ) of a segment in a world with z up; facing is ψ from the world's x axis [rad].
Eigen::Quaterniond StaticPose(Segment segment, const Observations& observations, double facing);

// The observations with the mountings that are missing taken from the intervals
// `calibration:static_pose`; as they are where there is nothing to take them from. Positions on the
// segments stay unknown (zero): the kinematic chain does without.
Observations AlignedByStaticPose(const Observations& observations, double facing);

}  // namespace brachium
