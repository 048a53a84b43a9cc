// The results of a sweep put together, beside its manifest:
//
// sweep.csv    a row per task: task, trial, method, a column per varied option, outcome ("done",
//              "refused", "failed", "unreadable", "missing"), trusted (1, 0), reason, then every
//              figure of any result; empty where unknown
// sweep.json   version 1: whether it is complete, counts by outcome, the figure chosen by, and for
//              each method the varied options, the mean error at each point, and the points chosen:
//              overall, by trial, and for each trial by all others
// timing.json  seconds and memory of the tasks by method: may differ between equal sweeps
// sweep_*.svg  io/sweep_figures.h
#pragma once

#include <string>

#include "io/sweep_rows.h"
#include "problems/sweep_table.h"

namespace brachium {

inline constexpr const char* kUsualSweepFigure = "relative.forearm_in_upper_arm.rmse_deg";

// Reads all results, each once; `rows` receives those of sweep.csv.
SweepTable ReadSweep(const SweepManifest& manifest, const std::string& figure, SweepRows* rows);

// Writes the files above into the sweep's folder. A merge of an incomplete sweep may always be
// replaced. Throws OutputExists where another complete merge stands, unless `overwrite`; OutputError.
void WriteSweep(const std::string& folder, const SweepTable& table, SweepRows* rows,
                bool overwrite);

}  // namespace brachium
