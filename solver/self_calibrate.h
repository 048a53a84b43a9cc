// How the sensors sit on upper arm and forearm, from arbitrary movement of the elbow.
//
// 1. The two sensors are followed as bodies on a ball joint (ball_joint.h): R_AB(t), forearm's sensor
//    in upper arm's, and where shoulder and elbow lie as the sensors see it.
// 2. Flexion axis j1 and pronation axis j2 from R_AB(t) (hinge_axes.h). Signs, the same on both sides of
//    the body (ISB axes): Y_F = j2 points from the forearm's sensor to the elbow, Z_U = j1 such that
//    bending is positive.
// 3. The zeros of flexion and of pronation, which no movement shows, keep their prior (elbow_zeros.h).
// Positions  of the sensors come along, where none was told: of the forearm's from the elbow, of the
//            upper arm's from the elbow and the told length.
// Sds        per axis as figures: what the axes leave open, the relative heading and a floor, or those
//            of the zeros; q_sigma, one number, is the largest of a segment's three.
// Refused    less than 10 s; an elbow that is seen where none can be, as where the arm moves less than
//            skin and straps do; an elbow that is hardly bent, or a forearm hardly turned; axes known to
//            less than 12 deg; a relative heading that acceleration does not hold; no pose for the
//            zero of pronation.
// Blind to   what moves with the motion: skin under the sensor of the upper arm turns less than the
//            bone. An elbow that departs further from its hinge than the smoother allows for is told.
#pragma once

#include "solver/calibrate.h"

namespace brachium {

// Mountings of the upper arm's and the forearm's sensor, whatever was told of them. Other segments keep
// the mounting that they have; one without gets none, with a note. Of the options only the floor
// of sigma is used.
Calibration SelfCalibrate(const Observations& observations, const CalibrationOptions& options);

}  // namespace brachium
