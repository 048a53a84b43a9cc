#include "io/comparison_figures.h"

#include <algorithm>
#include <functional>
#include <set>
#include <vector>

#include "io/plot/chart.h"
#include "io/plot/palette.h"
#include "problems/arm_model.h"

namespace brachium {
namespace {

constexpr double kGroupWidth = 0.8;  // of the boxes of one trial, along x

// A series of errors of one pair, in the unit of the picture, by what it is of.
using NamedErrors = std::map<std::string, std::vector<double>>;
using ErrorsOf = std::function<NamedErrors(const Evaluation&)>;

struct Kind {
  std::string title, label, file;
  ErrorsOf errors;
};

std::vector<double> Scaled(std::vector<double> values, double unit) {
  for (double& value : values) value /= unit;
  return values;
}

NamedErrors AnglesOf(const Evaluation& evaluation) {
  NamedErrors errors;
  for (const RelativeEvaluation& relative : evaluation.relative)
    errors[relative.name] = Scaled(relative.angle, kDegree);
  return errors;
}

NamedErrors DistancesOf(const Evaluation& evaluation) {
  NamedErrors errors;
  for (const auto& [name, position] : evaluation.positions)
    errors[name] = Scaled(position.distance, 1e-3);
  return errors;
}

const std::vector<Kind>& Kinds() {
  static const auto* const kinds =
      new std::vector<Kind>{{"Relative orientation", "error [deg]", "error", AnglesOf},
                            {"Position", "error [mm]", "position_error", DistancesOf}};
  return *kinds;
}

std::set<std::string> NamesIn(const Comparison& comparison, std::size_t trial, const Kind& kind) {
  std::set<std::string> names;
  for (std::size_t m = 0; m < comparison.methods.size(); ++m)
    for (const auto& [name, errors] : kind.errors(comparison.At(trial, m).evaluation))
      names.insert(name);
  return names;
}

Box BoxOf(double place, const std::vector<double>& errors, double rmse) {
  return {.place = place,
          .low = Quantile(errors, 0.05),
          .lower = Quantile(errors, 0.25),
          .middle = Quantile(errors, 0.5),
          .upper = Quantile(errors, 0.75),
          .high = Quantile(errors, 0.95),
          .dot = rmse};
}

double RmseOf(const std::vector<double>& errors) {
  const Series row =
      Eigen::Map<const Eigen::RowVectorXd>(errors.data(), static_cast<Eigen::Index>(errors.size()));
  return StatisticsOf(row).rmse;
}

// A group for each trial and what the error is of.
Chart BoxChart(const Comparison& comparison, const Kind& kind) {
  Chart chart{.title = kind.title + ": quartiles, 5 and 95 %; dot: rmse",
              .y = {.label = kind.label, .logarithmic = true}};
  const auto methods = static_cast<double>(comparison.methods.size());
  for (std::size_t m = 0; m < comparison.methods.size(); ++m)
    chart.boxes.push_back({.name = comparison.methods[m],
                           .colour = SeriesColour(m),
                           .width = 0.8 * kGroupWidth / methods});
  for (std::size_t t = 0; t < comparison.trials.size(); ++t) {
    const auto names = NamesIn(comparison, t, kind);
    for (const std::string& name : names) {
      const auto group = static_cast<double>(chart.x.categories.size());
      chart.x.categories.push_back(comparison.trials[t] + (names.size() > 1 ? " " + name : ""));
      for (std::size_t m = 0; m < comparison.methods.size(); ++m) {
        NamedErrors errors = kind.errors(comparison.At(t, m).evaluation);
        if (!errors.contains(name)) continue;
        const double offset = kGroupWidth * ((static_cast<double>(m) + 0.5) / methods - 0.5);
        chart.boxes[m].boxes.push_back(BoxOf(group + offset, errors[name], RmseOf(errors[name])));
      }
    }
  }
  return chart;
}

std::vector<Chart> ChartsOverTime(const Comparison& comparison, std::size_t trial,
                                  const Kind& kind) {
  std::vector<Chart> charts;
  for (const std::string& name : NamesIn(comparison, trial, kind)) {
    Chart chart{.title = comparison.trials[trial] + ": " + name,
                .x = {.label = "time [s]"},
                .y = {.label = kind.label, .logarithmic = true}};
    for (std::size_t m = 0; m < comparison.methods.size(); ++m) {
      const Evaluation& evaluation = comparison.At(trial, m).evaluation;
      NamedErrors errors = kind.errors(evaluation);
      if (errors.contains(name))
        chart.lines.push_back(
            {.name = comparison.methods[m],
             .x = evaluation.time,
             .y = errors[name],
             .stroke = {.colour = SeriesColour(m), .width = 1.2, .dashes = SeriesDashes(m)}});
    }
    charts.push_back(std::move(chart));
  }
  return charts;
}

}  // namespace

std::map<std::string, std::string> ComparisonFigures(const Comparison& comparison) {
  std::map<std::string, std::string> figures;
  std::vector<Chart> boxes;
  for (const Kind& kind : Kinds()) {
    Chart chart = BoxChart(comparison, kind);
    if (!chart.x.categories.empty()) boxes.push_back(std::move(chart));
    for (std::size_t t = 0; t < comparison.trials.size(); ++t)
      if (const auto charts = ChartsOverTime(comparison, t, kind); !charts.empty())
        figures[kind.file + "_over_time_" + comparison.trials[t] + ".svg"] = DrawCharts(charts);
  }
  const auto groups = [](const Chart& chart) { return chart.x.categories.size(); };
  std::size_t widest = 0;
  for (const Chart& chart : boxes) widest = std::max(widest, groups(chart));
  const auto per_group = 24.0 * static_cast<double>(comparison.methods.size()) + 20.0;
  const double width = std::max(860.0, 260.0 + per_group * static_cast<double>(widest));
  if (!boxes.empty()) figures["errors.svg"] = DrawCharts(boxes, {.width = width, .height = 420.0});
  return figures;
}

}  // namespace brachium
