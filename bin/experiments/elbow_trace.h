// What an elbow does over time, in the terms of Luinge et al. (2007).
#pragma once

#include <vector>

#include "problems/estimate.h"
#include "problems/trial.h"

namespace brachium {

// adduction: asin(z_U · y_F), the paper's γ with its sign put right [rad]; n_z: the vertical part of
// n = z_U × y_F, how much of the relative heading the adduction shows, 0 nothing and ±1 all of it. NaN
// where an attitude is unknown.
struct ElbowTrace {
  std::vector<double> time, adduction, n_z;
};

ElbowTrace TraceOf(const Estimate& estimate);
ElbowTrace TraceOf(const Reference& reference);

// Of what is not NaN, angles in deg.
double RmsOf(const std::vector<double>& angles);
std::vector<double> InDegrees(std::vector<double> angles);

}  // namespace brachium
