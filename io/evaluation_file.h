// The file that says how far an estimate is from its reference.
//
// evaluation.json, version 1. Angles in deg, lengths in m, each named by its unit; null is unknown.
// Every block of statistics holds samples_used, samples_left_out, bias, sd, rmse, median, p95, max
// and correlation (problems/statistics.h).
//   method, frames ("segment", "cluster")
//   clock_offset  seconds (reference = recording + offset), source ("given", "estimated",
//                 "unknown"), estimated, correlation of the speeds
//   samples       instants of the reference, used, left out
//   orientation   by segment; statistics of the whole angle, inclination and heading, `raw` and
//                 `aligned` alike
//   relative      by pair of neighbours, "forearm_in_upper_arm"; the same blocks
//                 (about their x, y and z apart, too)
//   joint_angles  by name; concordance (Lin) and limits_of_agreement (Bland & Altman) besides
//   positions     by point; statistics of the distance, horizontal and vertical, raw and aligned,
//                 and what became of the path
//   outcomes      by `estimate` and by `reference`: movement (what moved, count, moving_s, medians,
//                 epochs with peak speed, speed_peaks, sparc, ldlj, path_ratio), ranges of the
//                 joint angles, compensation by shoulder and trunk (problems/movement_outcomes.h)
// `alignment` says in words what was removed before the figures that stand directly in a block, and
// `removed` gives the constants of `aligned`: reference ≈ proximal * estimate * distal.
#pragma once

#include <string>

#include "problems/evaluation.h"

namespace brachium {

// The file's text, the same for the same evaluation.
std::string EvaluationJson(const Evaluation& evaluation);

// Writes evaluation.json into a folder, which is made if need be: aside first, then renamed. The
// same bytes again are no overwrite. Throws OutputExists where another evaluation stands that may
// not be overwritten, OutputError where writing fails.
void WriteEvaluation(const std::string& folder, const Evaluation& evaluation, bool overwrite);

}  // namespace brachium
