// An estimate for OpenSim.
#pragma once

#include <string>

#include "problems/estimate.h"

namespace brachium {

// Writes a folder: orientations.sto (a virtual sensor on each segment, w first, z up, whose axes
// are the segment's), placer_setup.xml and ik_setup.xml that turn z up into OpenSim's y up, and
// joint_angles.mot in degrees by the coordinate names of the MoBL-ARMS model (Saul et al., CMBBE 18,
// 2015):
//   elbow_flexion;  pro_sup = pronation - 90 (0 thumb forward);  elv_angle = plane;
//   shoulder_elv = elevation;  shoulder_rot = rotation + plane (the model undoes the plane first).
// OpenSim's placer takes row 0 for the model's default pose: let the trial begin in it. Instants at
// which a segment is not known are left out; an angle that is never known has no column, and one
// that is unknown at an instant leaves that instant out of the .mot. Throws OutputExists,
// OutputError, and std::invalid_argument for an estimate without attitudes.
void WriteOpenSim(const std::string& folder, const Estimate& estimate, bool overwrite);

}  // namespace brachium
