#include <limits>
#include <utility>

#include "io/name_places.h"
#include "io/sweep_merge.h"
#include "io/sweep_results.h"

namespace brachium {
namespace {

using Outcome = SweepResult::Outcome;

struct Cell {
  std::size_t trial, point;
  double error, adduction;
};

struct MethodCells {
  SweptMethod method;
  NamePlaces points{};
  std::vector<Cell> cells{};
};

double FigureOf(const SweepResult& result, const std::string& name) {
  const double* value = result.Find(name);
  return value == nullptr ? std::numeric_limits<double>::quiet_NaN() : *value;
}

void Count(const std::optional<SweepResult>& result, SweepTable* table) {
  ++table->tasks;
  if (!result)
    ++table->missing;
  else if (result->outcome == Outcome::kDone)
    ++table->done;
  else
    ++(result->outcome == Outcome::kRefused ? table->refused : table->failed);
  if (result && result->outcome == Outcome::kDone && !result->trusted) ++table->not_trusted;
}

void AddPoint(const SweepTask& task, SweptMethod* method) {
  std::vector<std::string> values, options;
  for (const auto& [name, value] : task.varied.items()) {
    options.push_back(name);
    values.push_back(value.is_string() ? value.get<std::string>() : value.dump());
  }
  method->options = options;
  method->points.push_back(values);
}

void Fill(MethodCells* cells, std::size_t trials) {
  SweptMethod& method = cells->method;
  const auto rows = static_cast<Eigen::Index>(trials);
  const auto columns = static_cast<Eigen::Index>(method.points.size());
  method.error.setConstant(rows, columns, std::numeric_limits<double>::quiet_NaN());
  method.adduction = method.error;
  for (const Cell& cell : cells->cells) {
    const auto row = static_cast<Eigen::Index>(cell.trial);
    const auto column = static_cast<Eigen::Index>(cell.point);
    method.error(row, column) = cell.error;
    method.adduction(row, column) = cell.adduction;
  }
  method.choice = ChooseParameters(method.error);
}

}  // namespace

SweepTable ReadSweep(const SweepManifest& manifest, const std::string& figure, SweepRows* rows) {
  SweepTable table{.figure = figure};
  NamePlaces trials, methods;
  std::vector<MethodCells> cells;
  for (std::size_t i = 0; i < manifest.size(); ++i) {
    const SweepTask task = manifest.At(i);
    const auto result = ReadSweepResult(manifest.folder(), task);
    Count(result, &table);
    rows->Append(task, result);
    const std::size_t trial = trials.Of(task.trial), m = methods.Of(task.method);
    if (m == cells.size()) cells.push_back({.method = {.method = task.method}});
    const std::size_t point = cells[m].points.Of(task.varied.dump());
    if (point == cells[m].method.points.size()) AddPoint(task, &cells[m].method);
    if (result && result->outcome == Outcome::kDone)
      cells[m].cells.push_back(
          {trial, point, FigureOf(*result, figure), FigureOf(*result, "adduction.rms_deg")});
  }
  table.trials = trials.names();
  for (MethodCells& method : cells) {
    Fill(&method, table.trials.size());
    table.methods.push_back(std::move(method.method));
  }
  return table;
}

}  // namespace brachium
