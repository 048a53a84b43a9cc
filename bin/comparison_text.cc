#include "bin/comparison_text.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include "bin/table.h"
#include "io/text.h"
#include "problems/arm_model.h"

namespace brachium {
namespace {

using Outcome = ComparedPair::Outcome;

constexpr double kNone = std::numeric_limits<double>::infinity();

struct Cell {
  std::string text;
  double value = kNone;
};

struct Row {
  std::string name;
  std::vector<Cell> cells;
};

struct Grid {
  std::string title;
  std::vector<Row> rows;
};

using Figures = std::map<std::string, double>;  // rmse by name
using FiguresOf = std::function<Figures(const Evaluation&)>;

Figures RelativeDegrees(const Evaluation& evaluation) {
  const bool raw = evaluation.frames == Reference::Frames::kSegment;
  Figures figures;
  for (const RelativeEvaluation& relative : evaluation.relative)
    figures[relative.name] =
        (raw ? relative.orientation.raw : relative.orientation.aligned).rotation.rmse / kDegree;
  return figures;
}

Figures PositionMillimetres(const Evaluation& evaluation) {
  Figures figures;
  for (const auto& [name, position] : evaluation.positions)
    figures[name] = position.aligned.distance.rmse / 1e-3;
  return figures;
}

std::string Number(double value) {
  return Fixed(value, value < 9.995 ? 2 : value < 999.95 ? 1 : 0);
}

Cell CellOf(const ComparedPair& pair, const FiguresOf& figures_of, const std::string& name) {
  if (pair.outcome == Outcome::kRefused) return {.text = "-"};
  if (pair.outcome != Outcome::kDone) return {.text = NameOf(pair.outcome)};
  const Figures figures = figures_of(pair.evaluation);
  const auto found = figures.find(name);
  if (found == figures.end() || !std::isfinite(found->second)) return {};
  return {.text = Number(found->second) + (pair.trusted ? "" : " *"), .value = found->second};
}

std::set<std::string> NamesIn(const Comparison& comparison, std::size_t trial,
                              const FiguresOf& figures_of) {
  std::set<std::string> names;
  for (std::size_t m = 0; m < comparison.methods.size(); ++m)
    for (const auto& [name, figure] : figures_of(comparison.At(trial, m).evaluation))
      names.insert(name);
  return names;
}

bool AnyDone(const Comparison& comparison, std::size_t trial) {
  for (std::size_t m = 0; m < comparison.methods.size(); ++m)
    if (comparison.At(trial, m).outcome == Outcome::kDone) return true;
  return false;
}

// A row for each trial and what the figure is of. A trial without any estimate has a row if
// `shows_empty`.
Grid GridOf(const Comparison& comparison, const std::string& title, const FiguresOf& figures_of,
            bool shows_empty) {
  std::set<std::string> all;
  for (std::size_t t = 0; t < comparison.trials.size(); ++t)
    all.merge(NamesIn(comparison, t, figures_of));
  const bool one = all.size() == 1;
  Grid grid{.title = title + (one ? ", " + *all.begin() : ""), .rows = {}};
  for (std::size_t t = 0; t < comparison.trials.size(); ++t) {
    std::set<std::string> names = NamesIn(comparison, t, figures_of);
    if (shows_empty && !AnyDone(comparison, t)) names.insert("");
    for (const std::string& name : names) {
      const bool named = !one && !name.empty();
      Row row{.name = comparison.trials[t] + (named ? ", " + name : ""), .cells = {}};
      for (std::size_t m = 0; m < comparison.methods.size(); ++m)
        row.cells.push_back(CellOf(comparison.At(t, m), figures_of, name));
      grid.rows.push_back(std::move(row));
    }
  }
  return grid;
}

std::vector<Grid> GridsOf(const Comparison& comparison) {
  std::vector<Grid> grids = {
      GridOf(comparison, "rmse [deg] of relative orientations", RelativeDegrees, true),
      GridOf(comparison, "rmse [mm] of positions after one heading and shift", PositionMillimetres,
             false)};
  std::erase_if(grids, [](const Grid& grid) { return grid.rows.empty(); });
  return grids;
}

// "METHOD on TRIAL, TRIAL: reason", by what happened.
std::vector<std::string> Sentences(const Comparison& comparison,
                                   const std::function<bool(const ComparedPair&)>& chosen) {
  std::map<std::pair<std::string, std::string>, std::string> trials;  // method, reason
  for (const ComparedPair& pair : comparison.pairs) {
    if (!chosen(pair)) continue;
    std::string& list = trials[{pair.method, pair.reason}];
    list += (list.empty() ? "" : ", ") + pair.trial;
  }
  std::vector<std::string> sentences;
  for (const auto& [key, list] : trials)
    sentences.push_back(key.first + " on " + list + ": " + key.second);
  return sentences;
}

struct Remarks {
  std::vector<std::string> refused, wrong, not_trusted;
};

Remarks RemarksOn(const Comparison& comparison) {
  const auto is = [](Outcome outcome) {
    return [outcome](const ComparedPair& pair) { return pair.outcome == outcome; };
  };
  Remarks remarks;
  remarks.refused = Sentences(comparison, is(Outcome::kRefused));
  remarks.wrong = Sentences(comparison, is(Outcome::kFailed));
  std::set<std::string> unreadable;
  for (const ComparedPair& pair : comparison.pairs)
    if (pair.outcome == Outcome::kUnreadable) unreadable.insert(pair.reason);
  remarks.wrong.insert(remarks.wrong.end(), unreadable.begin(), unreadable.end());
  remarks.not_trusted = Sentences(comparison, [](const ComparedPair& pair) {
    return pair.outcome == Outcome::kDone && !pair.trusted;
  });
  return remarks;
}

constexpr const char* kRefusedTitle = "Refused (-):";
constexpr const char* kWrongTitle = "Failed or unreadable:";
constexpr const char* kNotTrustedTitle = "Not to be trusted (*):";

std::string AsText(const Grid& grid, const std::vector<std::string>& methods) {
  std::vector<std::string> header = {""};
  header.insert(header.end(), methods.begin(), methods.end());
  Table table(header);
  for (const Row& row : grid.rows) {
    std::vector<std::string> cells = {row.name};
    for (const Cell& cell : row.cells) cells.push_back(cell.text);
    table.Add(std::move(cells));
  }
  return grid.title + "\n" + table.Text() + "\n";
}

std::string AsMarkdown(const Row& row) {
  double least = kNone;
  for (const Cell& cell : row.cells) least = std::min(least, cell.value);
  std::string text = "| " + row.name + " |";
  for (const Cell& cell : row.cells)
    text += cell.value == least && least < kNone && row.cells.size() > 1
                ? " **" + cell.text + "** |"
                : " " + cell.text + " |";
  return text + "\n";
}

std::string AsMarkdown(const Grid& grid, const std::vector<std::string>& methods) {
  std::string text = grid.title + ":\n\n| trial |", rule = "|---|";
  for (const std::string& method : methods) {
    text += " `" + method + "` |";
    rule += "---|";
  }
  text += "\n" + rule + "\n";
  for (const Row& row : grid.rows) text += AsMarkdown(row);
  return text + "\n";
}

std::string AsMarkdown(const char* title, const std::vector<std::string>& sentences) {
  if (sentences.empty()) return "";
  std::string text = std::string(title) + "\n";
  for (const std::string& sentence : sentences) text += "- " + sentence + "\n";
  return text + "\n";
}

}  // namespace

std::string ComparisonText(const Comparison& comparison) {
  std::string text;
  for (const Grid& grid : GridsOf(comparison)) text += AsText(grid, comparison.methods);
  const Remarks remarks = RemarksOn(comparison);
  return text + Listing(kRefusedTitle, remarks.refused) + Listing(kWrongTitle, remarks.wrong) +
         Listing(kNotTrustedTitle, remarks.not_trusted);
}

std::string ComparisonMarkdown(const Comparison& comparison) {
  std::string text;
  for (const Grid& grid : GridsOf(comparison)) text += AsMarkdown(grid, comparison.methods);
  const Remarks remarks = RemarksOn(comparison);
  return text + AsMarkdown(kRefusedTitle, remarks.refused) +
         AsMarkdown(kWrongTitle, remarks.wrong) + AsMarkdown(kNotTrustedTitle, remarks.not_trusted);
}

}  // namespace brachium
