#include "bin/experiments/sweep.h"

#include <algorithm>

#include "bin/table.h"
#include "io/plot/palette.h"
#include "io/text.h"

namespace brachium {
namespace {

std::string Degrees(double value) { return Fixed(value, value < 0.995 ? 2 : 1); }

Chart PanelChart(const std::string& title, const std::string& label,
                 const std::vector<Sweep>& sweeps, std::vector<double> Sweep::*values,
                 double Sweep::*without) {
  Chart chart{.title = title,
              .x = {.label = "sqrt(R) [deg]", .logarithmic = true},
              .y = {.label = label, .from_zero = true}};
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    const std::string colour = SeriesColour(i);
    chart.lines.push_back({.name = sweeps[i].trial,
                           .x = sweeps[i].sigma,
                           .y = sweeps[i].*values,
                           .stroke = {.colour = colour, .width = 1.5}});
    chart.rules.push_back({.value = sweeps[i].*without,
                           .label = "without",
                           .stroke = {.colour = colour, .dashes = "4 3"}});
  }
  return chart;
}

}  // namespace

double Sweep::LeastError() const { return *std::min_element(error.begin(), error.end()); }

std::string Sweep::PanelB() const {
  const auto least = std::min_element(error.begin(), error.end());
  const bool inside = least != error.begin() && least + 1 != error.end();
  const auto at = static_cast<std::size_t>(least - error.begin());
  return "least " + Degrees(*least) + " deg at " + Shortest(sigma[at]) + " deg, " +
         (inside ? "an interior minimum" : "the end of the sweep, no interior minimum") +
         "; without constraint " + Degrees(free_error);
}

std::string SweptName(const std::string& method, double sigma_deg) {
  return method + "_" + Shortest(sigma_deg);
}

std::string SweepText(const std::string& title, const std::vector<Sweep>& sweeps) {
  std::vector<std::string> header = {"sqrt(R)"}, without = {"without"}, reference = {"reference"};
  for (const Sweep& sweep : sweeps) {
    header.insert(header.end(), {sweep.trial + " A", "B"});
    without.insert(without.end(), {Degrees(sweep.free_adduction), Degrees(sweep.free_error)});
    reference.insert(reference.end(), {Degrees(sweep.reference_adduction), ""});
  }
  Table table(header);
  for (std::size_t i = 0; i < sweeps.front().sigma.size(); ++i) {
    std::vector<std::string> row = {Shortest(sweeps.front().sigma[i])};
    for (const Sweep& sweep : sweeps)
      row.insert(row.end(), {Degrees(sweep.adduction[i]), Degrees(sweep.error[i])});
    table.Add(row);
  }
  table.Add(without);
  table.Add(reference);
  return title + ": rms of the estimated adduction (A) and of the error (B) [deg]\n" + table.Text();
}

std::vector<Chart> SweepCharts(const std::string& what, const std::vector<Sweep>& sweeps) {
  return {PanelChart("Fig. 6 A, " + what, "rms adduction [deg]", sweeps, &Sweep::adduction,
                     &Sweep::free_adduction),
          PanelChart("Fig. 6 B, " + what, "rms error [deg]", sweeps, &Sweep::error,
                     &Sweep::free_error)};
}

}  // namespace brachium
