// The motion of an estimate as a table: estimate.csv.
#pragma once

#include <string>

#include "problems/estimate.h"

namespace brachium {

// Columns: time_s; per segment, proximal first, NAME_qw.._qz and, where known, the standard
// deviations NAME_rx_sd_deg.._rz_sd_deg about its own axes; per point NAME_px.._pz [m]; joint angles
// [deg] of the joints whose both segments are estimated, of the shoulder against a thorax, and the
// shoulder's elevation in any case. What is not finite is an empty cell.
void WriteEstimateCsv(const Estimate& estimate, const std::string& file);

// Time, rotations with their deviations, positions; the angles follow from them. Throws InputError.
Estimate ReadEstimateCsv(const std::string& file);

}  // namespace brachium
