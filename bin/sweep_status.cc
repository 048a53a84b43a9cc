// brachium sweep status: how far a sweep is.
#include <iostream>

#include "bin/commands.h"
#include "bin/help.h"
#include "bin/sweep_text.h"
#include "io/sweep_results.h"

namespace brachium {
namespace {

struct StatusFlags {
  std::string manifest;
  bool missing = false;

  template <typename Flags, typename Visitor>
  static void Visit(Flags& flags, Visitor&& visit) {
    visit("manifest", flags.manifest, "The manifest; results are beside it.");
    visit("missing", flags.missing,
          "Print only the tasks without a valid result, missing and failed, as Slurm's --array "
          "takes them: 0-3,7.");
  }
};

const CommandHelp kHelp = {"--manifest=FILE [--missing]",
                           "Counts the tasks of a sweep that are done, failed and missing, and "
                           "says why those failed that did."};

struct Status {
  std::size_t done = 0, failed = 0, missing = 0;
  std::vector<std::size_t> open;  // failed or missing
  std::string reasons;
};

Status StatusOf(const SweepManifest& manifest) {
  Status status;
  for (std::size_t i = 0; i < manifest.size(); ++i) {
    const SweepTask task = manifest.At(i);
    const auto result = ReadSweepResult(manifest.folder(), task);
    if (result && result->IsFinal()) {
      ++status.done;
      continue;
    }
    status.open.push_back(i);
    ++(result ? status.failed : status.missing);
    if (result)
      status.reasons += "  task " + std::to_string(i) + ", " + task.method + " on " + task.trial +
                        ": " + result->reason + "\n";
  }
  return status;
}

}  // namespace

int RunSweepStatus(CommandLine& line) {
  StatusFlags flags;
  line.Add("Flags", flags);
  if (ShowHelp(line, kHelp)) return kGood;
  line.Read();
  RequireGiven(flags.manifest, "manifest");
  const SweepManifest manifest(flags.manifest);
  const Status status = StatusOf(manifest);
  if (flags.missing)
    std::cout << ArraySpecification(status.open) << "\n";
  else
    std::cout << manifest.size() << " tasks: " << status.done << " done, " << status.failed
              << " failed, " << status.missing << " missing\n"
              << status.reasons;
  return kGood;
}

}  // namespace brachium
