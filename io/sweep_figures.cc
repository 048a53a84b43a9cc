#include "io/sweep_figures.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>

#include "io/plot/figures.h"
#include "io/plot/heat_map.h"
#include "io/plot/palette.h"
#include "problems/statistics.h"

namespace brachium {
namespace {

std::optional<double> NumberFrom(const std::string& text) {
  double number = 0.0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || rest != text.data() + text.size()) return std::nullopt;
  return number;
}

std::size_t BasePoint(const SweptMethod& method) {
  return static_cast<std::size_t>(method.choice.overall.value_or(0));
}

// The varied options that are numbers and have more than one value.
std::vector<std::size_t> NumericOptions(const SweptMethod& method) {
  std::vector<std::size_t> numeric;
  for (std::size_t o = 0; o < method.options.size(); ++o) {
    const auto along = PointsAlong(method, o, BasePoint(method));
    if (along.size() > 1 && std::all_of(along.begin(), along.end(), [&](std::size_t p) {
          return NumberFrom(method.points[p][o]).has_value();
        }))
      numeric.push_back(o);
  }
  return numeric;
}

// The points along an option by its value, in rising order.
std::vector<std::pair<double, std::size_t>> Rising(const SweptMethod& method, std::size_t option) {
  std::vector<std::pair<double, std::size_t>> rising;
  for (const std::size_t p : PointsAlong(method, option, BasePoint(method)))
    rising.emplace_back(*NumberFrom(method.points[p][option]), p);
  std::sort(rising.begin(), rising.end());
  return rising;
}

// Whether values lie more evenly by their logarithms.
bool LooksLogarithmic(const std::vector<double>& x) {
  return x.size() > 2 && x.front() > 0.0 && x[x.size() - 1] - x[x.size() - 2] > 2.0 * (x[1] - x[0]);
}

Chart LinesOf(const SweptMethod& method, std::size_t option, const Eigen::MatrixXd& values,
              const std::string& label, std::size_t place) {
  std::vector<double> x;
  Eigen::MatrixXd lines(values.rows(), 0);
  for (const auto& [value, point] : Rising(method, option)) {
    x.push_back(value);
    lines.conservativeResize(Eigen::NoChange, lines.cols() + 1);
    lines.rightCols(1) = values.col(static_cast<Eigen::Index>(point));
  }
  Chart chart{.title = method.method,
              .x = {.label = method.options[option], .logarithmic = LooksLogarithmic(x)},
              .y = {.label = label, .from_zero = true}};
  AddWithQuartiles(x, lines, "median", SeriesColour(place), &chart);
  return chart;
}

// The same limits for the n-th chart of every column.
void ShareScales(std::vector<std::vector<Chart>>* columns) {
  for (std::size_t row = 0; row < columns->front().size(); ++row) {
    std::vector<double> values;
    for (const auto& column : *columns)
      for (const LineSeries& line : column[row].lines)
        values.insert(values.end(), line.y.begin(), line.y.end());
    for (auto& column : *columns) column[row].y.limits = RangeOf(column[row].y, values);
  }
}

bool KnowsAdduction(const SweepTable& table) {
  return std::any_of(table.methods.begin(), table.methods.end(), [](const SweptMethod& method) {
    return !method.adduction.array().isNaN().all();
  });
}

std::string Lines(const SweepTable& table) {
  std::vector<std::vector<Chart>> columns;
  for (const SweptMethod& method : table.methods) {
    const auto numeric = NumericOptions(method);
    if (numeric.empty()) continue;
    const std::size_t place = columns.size(), option = numeric.front();
    columns.emplace_back();
    if (KnowsAdduction(table))
      columns.back().push_back(
          LinesOf(method, option, method.adduction, "rms adduction [deg]", place));
    columns.back().push_back(LinesOf(method, option, method.error, table.figure, place));
  }
  if (columns.empty()) return "";
  ShareScales(&columns);
  return DrawColumns(columns, {.width = 520.0, .height = 320.0});
}

double MedianError(const SweptMethod& method, std::size_t point) {
  const Eigen::VectorXd column = method.error.col(static_cast<Eigen::Index>(point));
  return Quantile({column.begin(), column.end()}, 0.5);
}

std::string Map(const SweptMethod& method, std::size_t a, std::size_t b,
                const std::string& figure) {
  HeatMap map{.title = method.method + ": median over the trials",
              .x = {.label = method.options[a]},
              .y = {.label = method.options[b]},
              .value_label = figure};
  const auto columns = Rising(method, a), rows = Rising(method, b);
  map.values.resize(static_cast<Eigen::Index>(rows.size()),
                    static_cast<Eigen::Index>(columns.size()));
  map.values.setConstant(std::numeric_limits<double>::quiet_NaN());
  for (const auto& [value, point] : rows) map.y.categories.push_back(method.points[point][b]);
  for (std::size_t c = 0; c < columns.size(); ++c) {
    map.x.categories.push_back(method.points[columns[c].second][a]);
    for (const std::size_t p : PointsAlong(method, b, columns[c].second)) {
      const auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& r) {
        return method.points[r.second][b] == method.points[p][b];
      });
      map.values(row - rows.begin(), static_cast<Eigen::Index>(c)) = MedianError(method, p);
    }
  }
  return DrawHeatMap(map, {.width = 860.0, .height = 420.0});
}

}  // namespace

std::map<std::string, std::string> SweepFigures(const SweepTable& table) {
  std::map<std::string, std::string> figures;
  if (const std::string lines = Lines(table); !lines.empty()) figures["sweep_lines.svg"] = lines;
  for (const SweptMethod& method : table.methods) {
    const auto numeric = NumericOptions(method);
    for (std::size_t i = 0; i < numeric.size(); ++i)
      for (std::size_t j = i + 1; j < numeric.size(); ++j)
        figures["sweep_map_" + method.method + "_" + method.options[numeric[i]] + "_" +
                method.options[numeric[j]] + ".svg"] =
            Map(method, numeric[i], numeric[j], table.figure);
  }
  return figures;
}

}  // namespace brachium
