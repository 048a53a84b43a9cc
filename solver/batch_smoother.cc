#include "solver/batch_smoother.h"

namespace brachium {
bool SmootherOptions::IsValid(std::string*) const { return true; }
bool BatchSmoother::Accepts(const Observations&, std::string*) const { return true; }
Estimate BatchSmoother::Run(const Observations&, const Progress&) const { return {}; }
}  // namespace brachium
