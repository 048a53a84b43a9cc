// Putting a sweep together, and saying what came of it.
#pragma once

#include <string>

#include "problems/sweep_table.h"

namespace brachium {

// The choices as a table for the terminal.
std::string SweepText(const SweepTable& table);

// Merges and prints; the exit code. Throws UsageError when no result has that figure, naming the
// nearest.
int MergeSweep(const std::string& manifest, const std::string& figure, bool partial,
               bool overwrite);

}  // namespace brachium
