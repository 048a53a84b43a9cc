// brachium report: results as a page to look at.
#include <filesystem>
#include <iostream>
#include <string>

#include "bin/commands.h"
#include "bin/help.h"
#include "bin/lists.h"
#include "bin/run_facts.h"
#include "bin/termination.h"
#include "io/output_folder.h"
#include "io/report/page.h"
#include "io/report/read_report.h"

namespace brachium {
namespace {

struct ReportFlags {
  std::string estimates;
  std::string trial;
  std::string output;
  bool overwrite = false;

  bool IsValid(std::string* why) const {
    if (SplitList(estimates).empty()) return *why = "estimates names no folder", false;
    if (!output.ends_with(".html"))
      return *why = "--output is '" + output + "'; expected a file NAME.html", false;
    return true;
  }

  template <typename Flags, typename Visitor>
  static void Visit(Flags& flags, Visitor&& visit) {
    visit("estimates", flags.estimates,
          "The folders of estimates, comparisons and merged sweeps, parted by commas.");
    visit("trial", flags.trial,
          "The trial folders of the estimates, for their references, as a list with commas or a "
          "pattern in quotes; when left out, those that the estimates were made from, if they are "
          "still there and unchanged.");
    visit("output", flags.output,
          "The page to be written, NAME.html. Its figures go into the folder NAME_figures as SVG.");
    visit("overwrite", flags.overwrite, "Replace an older report.");
  }
};

const CommandHelp kHelp = {
    "--estimates=DIR[,DIR...] --output=FILE.html [flags]",
    "Shows results as one HTML page that needs no network: joint angles over time with their "
    "uncertainty, rests and reference, errors, agreement, residuals, observability, movements, "
    "methods side by side, and the arm in space, to be played, scrubbed and turned. Built without "
    "npm the program makes pages whose charts are pictures."};

std::vector<std::string> TrialPaths(const std::string& list) {
  std::vector<std::string> paths;
  for (const NamedFolder& folder : TrialFolders(list)) paths.push_back(folder.path);
  return paths;
}

}  // namespace

int RunReport(CommandLine& line) {
  ReportFlags flags;
  line.Add("Flags", flags);
  if (ShowHelp(line, kHelp)) return kGood;
  line.Read();
  RequireGiven(flags.estimates, "estimates");
  RequireGiven(flags.output, "output");
  RequireValid(flags);

  Report report = ReadReport(SplitList(flags.estimates), TrialPaths(flags.trial));
  report.version = ProgramVersion();
  const ReportPage page = PageOf(report, EmbeddedPageFiles());
  const std::filesystem::path output = flags.output;
  const std::filesystem::path figures =
      output.parent_path() / (output.stem().string() + "_figures");
  {
    const WithoutInterruption writing;
    WriteOneFile(output.string(), page.html, flags.overwrite);
    for (const auto& [name, svg] : page.figures)
      WriteOneFile((figures / name).string(), svg, flags.overwrite);
  }
  std::cout << "Report in " << flags.output;
  if (!page.figures.empty()) std::cout << ", its figures in " << figures.string();
  std::cout << "\n";
  return kGood;
}

}  // namespace brachium
