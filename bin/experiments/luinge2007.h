// What the tables and the figures of luinge2007 share.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "bin/experiments/experiment.h"
#include "bin/experiments/sweep.h"

namespace brachium {

inline constexpr double kPaperSigma = 10.0;  // sqrt(R) of Figs 4 and 5 [deg]
inline const std::string kFree = "luinge_unconstrained", kTied = "luinge", kSmoother = "smoother";
inline const std::string kOn = "_switched_on";  // without biases from rests

inline const std::string kCalibrationTrial = "calibration";

double DefaultSigmaDeg();  // of the smoother's adduction
std::vector<std::string> Routines(bool quick);

// Fig. 6 of the filter without biases, with those of rests, and of the smoother.
struct LuingeSweeps {
  std::vector<Sweep> on, rests, smoother;
};
std::map<std::string, std::string> LuingeFigures(const ExperimentResults& results,
                                                 const LuingeSweeps& sweeps, bool quick);

}  // namespace brachium
