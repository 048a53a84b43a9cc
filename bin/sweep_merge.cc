// brachium sweep merge: from results to a table, figures and the points to recommend.
#include "bin/sweep_merge.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string_view>

#include "bin/commands.h"
#include "bin/help.h"
#include "bin/termination.h"
#include "io/sweep_merge.h"
#include "io/text.h"

namespace brachium {
namespace {

struct MergeFlags {
  std::string manifest;
  std::string figure = kUsualSweepFigure;
  bool partial = false;
  bool overwrite = false;

  template <typename Flags, typename Visitor>
  static void Visit(Flags& flags, Visitor&& visit) {
    visit("manifest", flags.manifest, "The manifest; results are beside it.");
    visit("figure", flags.figure,
          "The error to choose by, less is better: a column of sweep.csv, as "
          "positions.foot.rmse_m.");
    visit("partial", flags.partial, "Merge what there is, even if tasks are missing or failed.");
    visit("overwrite", flags.overwrite, "Replace another merge of the complete sweep.");
  }
};

const CommandHelp kHelp = {
    "--manifest=FILE [--figure=NAME] [--partial]",
    "Writes sweep.csv (a row per task), sweep.json (the points chosen) and figures beside the "
    "manifest. Recommends for each method the point of the least mean error, and says what a new "
    "trial may expect: the mean error of each trial at the point that all others choose. Exits "
    "with 4, writing nothing, when tasks are missing or failed, unless --partial."};

void RequireFigure(const std::string& figure, const std::vector<std::string>& figures) {
  if (figures.empty() || std::find(figures.begin(), figures.end(), figure) != figures.end()) return;
  const std::vector<std::string_view> known(figures.begin(), figures.end());
  throw UsageError("--figure=" + figure + " is in none of the results" + DidYouMean(figure, known) +
                   " (known: " + Listed(known) + ")");
}

std::string PointText(const SweptMethod& method, const ParameterChoice::Point& point) {
  if (!point) return "none";
  std::string text;
  for (std::size_t i = 0; i < method.options.size(); ++i)
    text += (i == 0 ? "" : ", ") + method.options[i] + "=" +
            method.points[static_cast<std::size_t>(*point)][i];
  return text.empty() ? "as it is" : text;
}

std::string Figures(double value) { return std::isnan(value) ? "-" : Fixed(value, 3); }

std::string ChoiceText(const SweptMethod& method) {
  return method.method + ": " + PointText(method, method.choice.overall) + "\n  mean error " +
         Figures(method.choice.overall_error) + "; each trial at the point that the others chose " +
         Figures(method.choice.others_error) + "\n";
}

}  // namespace

std::string SweepText(const SweepTable& table) {
  std::string text =
      std::to_string(table.tasks) + " tasks on " + std::to_string(table.trials.size()) +
      " trials: " + std::to_string(table.done) + " done (" + std::to_string(table.not_trusted) +
      " of them not to be trusted), " + std::to_string(table.refused) + " refused, " +
      std::to_string(table.failed) + " failed, " + std::to_string(table.missing) +
      " missing\nBest points by " + table.figure + "\n";
  for (const SweptMethod& method : table.methods) text += ChoiceText(method);
  return text;
}

int MergeSweep(const std::string& file, const std::string& figure, bool partial, bool overwrite) {
  const SweepManifest manifest(file);
  SweepRows rows(manifest.folder());
  const SweepTable table = ReadSweep(manifest, figure, &rows);
  if (!table.Complete() && !partial) {
    std::cerr << "brachium: " << table.missing << " tasks are missing and " << table.failed
              << " failed; see brachium sweep status, or say --partial\n";
    return kIncompleteSweep;
  }
  RequireFigure(figure, rows.figures());
  {
    const WithoutInterruption writing;
    WriteSweep(manifest.folder(), table, &rows, overwrite);
  }
  std::cout << SweepText(table) << "Merged into " << manifest.folder() << "/sweep.csv\n";
  return kGood;
}

int RunSweepMerge(CommandLine& line) {
  MergeFlags flags;
  line.Add("Flags", flags);
  if (ShowHelp(line, kHelp)) return kGood;
  line.Read();
  RequireGiven(flags.manifest, "manifest");
  return MergeSweep(flags.manifest, flags.figure, flags.partial, flags.overwrite);
}

}  // namespace brachium
