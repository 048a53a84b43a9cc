// A sweep of the sigma of the elbow's adduction, as in Fig. 6 of Luinge et al. (2007).
#pragma once

#include <string>
#include <vector>

#include "io/plot/chart.h"

namespace brachium {

// On one trial; all in deg, rms over the trial.
struct Sweep {
  std::string trial;
  std::vector<double> sigma{};      // sqrt(R), rising
  std::vector<double> adduction{};  // that was estimated: panel A
  std::vector<double> error{};      // of the forearm in the upper arm: panel B
  double reference_adduction = 0.0;
  double free_adduction = 0.0;  // without the constraint
  double free_error = 0.0;

  double LeastError() const;
  // "least 12.7 deg at 60 deg, inside the sweep: ...": where panel B has its minimum.
  std::string PanelB() const;
};

// "luinge_10": the run with that sigma [deg].
std::string SweptName(const std::string& method, double sigma_deg);

// Both panels as a table, sigmas down, trials across.
std::string SweepText(const std::string& title, const std::vector<Sweep>& sweeps);

// Panels A and B.
std::vector<Chart> SweepCharts(const std::string& what, const std::vector<Sweep>& sweeps);

}  // namespace brachium
