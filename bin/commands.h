// The commands of the program. Each registers its flags, reads the command line, does its work and
// returns the exit code. They throw UsageError, InputError and OutputError; main() catches.
#pragma once

#include "bin/flags.h"

namespace brachium {

inline constexpr int kGood = 0;
inline constexpr int kWrongUsage = 1;
inline constexpr int kWrongInput = 2;
inline constexpr int kNotToBeTrusted = 3;
inline constexpr int kIncompleteSweep = 4;

int RunReconstruct(CommandLine& line);
int RunEvaluate(CommandLine& line);
int RunCalibrate(CommandLine& line);
int RunCompare(CommandLine& line);
int RunExport(CommandLine& line);
int RunImport(CommandLine& line);
int RunInspect(CommandLine& line);
int RunSimulate(CommandLine& line);
int RunSweepPlan(CommandLine& line);
int RunSweepRun(CommandLine& line);
int RunSweepStatus(CommandLine& line);
int RunSweepMerge(CommandLine& line);
int RunSweepSubmit(CommandLine& line);

}  // namespace brachium
