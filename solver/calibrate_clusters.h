// How the marker clusters of a reference sit on their segments, by the same movements as the sensors:
// Luinge, Veltink & Baten (2007), section 2.4.
//
// A cluster C is taken for a sensor that its own orientations move:
//   rate   Log(q_VC(t-)⁻¹ q_VC(t+))/(t+ - t-) over 0.1 s, which takes the markers' noise down, and
//          never across a gap;
//   force  g R_VC(t)ᵀ e_z: a reference knows the vertical whether it rests or moves.
// What calibrate.h refuses or is blind to is the same here. Sensors and clusters that are calibrated
// by the same movements share what was wrong with these: they agree better than either is right.
#pragma once

#include <optional>

#include "problems/trial.h"
#include "solver/calibrate.h"

namespace brachium {

// What a sensor on the cluster would have recorded, on the recordings' clock (an unknown offset of
// the clocks is taken as none). Absent where fewer than two samples can be told.
std::optional<Recording> ClusterRecording(const Reference& reference, Segment segment);

// q_BS of each mounting is q_BC, cluster to segment. Only of the reference's segments that have
// labelled movements; the others are noted.
Calibration CalibrateClusters(const Reference& reference, const Observations& observations,
                              const CalibrationOptions& options);

}  // namespace brachium
