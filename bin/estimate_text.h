// What the terminal shows of an estimate and of the trial that it came from.
#pragma once

#include <ostream>
#include <string>

#include "io/findings.h"
#include "problems/estimate.h"

namespace brachium {

// How it went, residuals by kind, constants, rests, figures and notes.
std::string EstimateText(const std::string& trial, const Estimate& estimate);

// Says of a result that is not to be trusted that it is not, and why.
void WarnOfDistrust(const Diagnostics& diagnostics, std::ostream& to);

// Defaults taken, repairs, warnings; empty when there is nothing to say.
std::string FindingsText(const Findings& findings);

}  // namespace brachium
