// How the sensors sit on upper arm and forearm, from arbitrary movement of the elbow.
//
// 1. The two sensors are followed as bodies on a ball joint of which nothing is known: the smoother
//    with mountings of identity, joints 0.3 m (sd) from anywhere, no adduction. It tells R_AB(t), forearm
//    sensor in upper-arm sensor, and where shoulder and elbow lie as seen by the sensors.
// 2. Flexion axis j1 and pronation axis j2 from R_AB(t): hinge_axes.h.   Z_U = ±j1,  Y_F = ±j2.
// 3. Signs, the same on both sides of the body (ISB axes):
//      Y_F points from the forearm's sensor towards the elbow;
//      Y_U points from elbow to shoulder, made square to Z_U;
//      Z_U such that bending is positive: z_U · (y_U × y_F) = sin a > 0 on average.
// 4. No movement of the elbow shows the zeros of flexion (the rotation of the upper arm's sensor about
//    Z_U) and of pronation (that of the forearm's about Y_F). For flexion the line from elbow to
//    shoulder and the start pose are weighted; pronation has the start pose only. Where the
//    elbow would overstretch, beyond -5 deg in 1 % of the time, the zero of flexion is moved. Where none is told
//    and the arm hangs when the recordings begin, the thumb is taken to point forward, sd 30 deg.
// Positions  of the sensors come along, where none was told: of the forearm's from the elbow, of the
//            upper arm's from the elbow and the told length.
// Sds        per axis as figures: of j1 and j2 by the motion, the relative heading and a floor for soft
//            tissue; q_sigma is the largest of a segment's three.
// Refused    less than 10 s; an elbow that is hardly bent, or a forearm hardly turned; a relative
//            heading that acceleration does not hold; no pose for the zero of pronation.
// Blind to   what moves with the motion: skin under the sensor of the upper arm turns less than the bone.
#pragma once

#include "solver/calibrate.h"

namespace brachium {

// Mountings of the upper arm's and the forearm's sensor, whatever was told of them. Other segments keep
// the mounting that they have; one without gets none, with a note. Of the options only the floor
// of sigma is used.
Calibration SelfCalibrate(const Observations& observations, const CalibrationOptions& options);

}  // namespace brachium
