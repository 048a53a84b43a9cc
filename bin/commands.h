// The commands of the program. Each registers its flags, reads the command line, does its work and
// returns the exit code. They throw UsageError, InputError and OutputError; main() catches.
#pragma once

#include <span>
#include <string_view>

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
int RunCompletion(CommandLine& line);
int RunExport(CommandLine& line);
int RunImport(CommandLine& line);
int RunInspect(CommandLine& line);
int RunMan(CommandLine& line);
int RunReport(CommandLine& line);
int RunSimulate(CommandLine& line);
int RunSweepPlan(CommandLine& line);
int RunSweepRun(CommandLine& line);
int RunSweepStatus(CommandLine& line);
int RunSweepMerge(CommandLine& line);
int RunSweepSubmit(CommandLine& line);

struct Command {
  std::string_view name;  // "sweep plan" is one command in two words
  int (*run)(CommandLine&);
  const char* summary;
};

// All commands, in the order in which they are shown.
std::span<const Command> Commands();

// What the program is, in a sentence.
inline constexpr const char* kPurpose =
    "brachium reconstructs arm motion from body-worn inertial sensors.";

inline constexpr const char* kExitCodes =
    "0 good, 1 wrong flag, 2 wrong input, 3 result not to be trusted, 4 incomplete sweep.";

}  // namespace brachium
