#include "bin/commands.h"

#include <array>

namespace brachium {
namespace {

constexpr std::array kCommands = {
    Command{"reconstruct", RunReconstruct, "estimates the arm's motion from a trial folder"},
    Command{"evaluate", RunEvaluate, "compares an estimate with the trial's reference"},
    Command{"compare", RunCompare, "runs several methods on several trials, side by side"},
    Command{"calibrate", RunCalibrate, "finds how sensors sit on their segments from movements"},
    Command{"completion", RunCompletion, "prints what lets bash complete commands and flags"},
    Command{"export", RunExport, "writes an estimate in the files of OpenSim"},
    Command{"import", RunImport, "makes a trial folder from the exports of makers' programs"},
    Command{"inspect", RunInspect, "says what is in a trial folder and what is wrong with it"},
    Command{"man", RunMan, "prints the manual page"},
    Command{"report", RunReport, "shows results as a page: charts, tables, the arm in space"},
    Command{"simulate", RunSimulate, "writes a trial folder whose truth is known"},
    Command{"sweep plan", RunSweepPlan, "lists the tasks of a parameter sweep over many trials"},
    Command{"sweep run", RunSweepRun, "runs tasks of a sweep, all or a part"},
    Command{"sweep status", RunSweepStatus, "says which tasks are done, failed, missing"},
    Command{"sweep merge", RunSweepMerge, "puts the results together and chooses the best points"},
    Command{"sweep submit", RunSweepSubmit, "hands a sweep to Slurm, or runs it here"},
};

}  // namespace

std::span<const Command> Commands() { return kCommands; }

}  // namespace brachium
