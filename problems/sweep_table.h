// The figures of a sweep that a recommendation rests on: errors by trial and parameter point.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "problems/parameter_choice.h"

namespace brachium {

// One method over its points. Matrices: a row per trial, a column per point, NaN where unknown.
struct SweptMethod {
  std::string method{};
  std::vector<std::string> options{};              // those varied, as the points give them
  std::vector<std::vector<std::string>> points{};  // the values at each point, as text
  Eigen::MatrixXd error{};                         // in the unit of its figure
  Eigen::MatrixXd adduction{};                     // rms of the estimate's elbow adduction [deg]
  ParameterChoice choice{};                        // by `error`
};

struct SweepTable {
  std::string figure{};  // what `error` is
  std::vector<std::string> trials{};
  std::vector<SweptMethod> methods{};
  std::size_t tasks = 0, done = 0, refused = 0, failed = 0, missing = 0, not_trusted = 0;

  bool Complete() const { return done + refused == tasks; }
};

// Points that differ from point `base` in no option but number `option`, in their order.
std::vector<std::size_t> PointsAlong(const SweptMethod& method, std::size_t option,
                                     std::size_t base);

}  // namespace brachium
