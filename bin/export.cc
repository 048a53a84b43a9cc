// brachium export: an estimate in the files of other programs.
#include <iostream>
#include <stdexcept>
#include <string>

#include "bin/commands.h"
#include "bin/estimate_text.h"
#include "bin/help.h"
#include "bin/termination.h"
#include "io/estimate_folder.h"
#include "io/formats/opensim_write.h"
#include "io/input_error.h"

namespace brachium {
namespace {

struct ExportFlags {
  std::string estimate;
  std::string output;
  bool overwrite = false;

  template <typename Flags, typename Visitor>
  static void Visit(Flags& flags, Visitor&& visit) {
    visit("estimate", flags.estimate, "The estimate folder.");
    visit("output", flags.output, "The folder to be written.");
    visit("overwrite", flags.overwrite, "Replace an older folder.");
  }
};

const CommandHelp kHelp = {
    "--estimate=DIR --output=DIR [flags]",
    "Writes an estimate for OpenSim: orientations.sto with the setups of its placer and of its "
    "inverse kinematics, and joint_angles.mot by the coordinate names of the MoBL-ARMS model. The "
    "placer takes the first row for the model's default pose."};

}  // namespace

int RunExport(CommandLine& line) {
  ExportFlags flags;
  line.Add("Flags", flags);
  if (ShowHelp(line, kHelp)) return kGood;
  line.Read();
  RequireGiven(flags.estimate, "estimate");
  RequireGiven(flags.output, "output");

  const Estimate estimate = ReadEstimate(flags.estimate);
  const WithoutInterruption writing;
  try {
    WriteOpenSim(flags.output, estimate, flags.overwrite);
  } catch (const std::invalid_argument& error) {
    throw InputError(flags.estimate, 0, error.what());
  }
  WarnOfDistrust(estimate.diagnostics, std::cerr);
  std::cout << "Written for OpenSim into " << flags.output << "\n";
  return kGood;
}

}  // namespace brachium
