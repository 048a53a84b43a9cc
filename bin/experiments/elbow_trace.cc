#include "bin/experiments/elbow_trace.h"

#include <algorithm>
#include <cmath>

#include "problems/arm_angles.h"
#include "problems/statistics.h"
#include "solver/baselines/elbow_constraint.h"

namespace brachium {
namespace {

ElbowTrace TraceOf(const std::vector<double>& time, const Attitudes& q_WB) {
  ElbowTrace trace{.time = time, .adduction = {}, .n_z = {}};
  const auto& q_WU = q_WB.at(Segment::kUpperArm);
  const auto& q_WF = q_WB.at(Segment::kForearm);
  for (std::size_t i = 0; i < time.size(); ++i) {
    const PredictedAdduction predicted = PredictAdduction(q_WF[i], q_WU[i]);
    trace.adduction.push_back(std::asin(std::clamp(predicted.sine, -1.0, 1.0)));
    trace.n_z.push_back(predicted.H_W[2]);
  }
  return trace;
}

}  // namespace

ElbowTrace TraceOf(const Estimate& estimate) { return TraceOf(estimate.time, estimate.q_WB); }

ElbowTrace TraceOf(const Reference& reference) { return TraceOf(reference.time, reference.q_VB); }

double RmsOf(const std::vector<double>& angles) {
  const Series row =
      Eigen::Map<const Eigen::RowVectorXd>(angles.data(), static_cast<Eigen::Index>(angles.size()));
  return StatisticsOf(row).rmse / kDegree;
}

std::vector<double> InDegrees(std::vector<double> angles) {
  for (double& angle : angles) angle /= kDegree;
  return angles;
}

}  // namespace brachium
