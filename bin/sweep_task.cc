#include "bin/sweep_task.h"

#include <algorithm>
#include <exception>

#include "bin/judge.h"
#include "io/input_error.h"
#include "problems/arm_angles.h"

namespace brachium {
namespace {

using Outcome = SweepResult::Outcome;

void AddAdduction(const Estimate& estimate, SweepResult* result) {
  const auto angles = JointAngleSeries(estimate.q_WB, estimate.side);
  const auto found = angles.find("elbow_carrying");
  if (found == angles.end()) return;
  const Series series = Eigen::Map<const Eigen::RowVectorXd>(
      found->second.data(), static_cast<Eigen::Index>(found->second.size()));
  const Statistics statistics = StatisticsOf(series);
  if (statistics.used == 0) return;
  result->figures.emplace_back("adduction.rms_deg", statistics.rmse / kDegree);
  result->figures.emplace_back("adduction.sd_deg", statistics.sd / kDegree);
}

std::string WhyNotTrusted(const Diagnostics& diagnostics) {
  return diagnostics.singular ? "the information matrix is singular"
                              : "not converged: " + diagnostics.termination;
}

SweepResult Judged(const Estimate& estimate, const TrialFolder& folder) {
  const Evaluation evaluation = Evaluate(estimate, *folder.trial.reference);
  if (evaluation.used == 0)
    return {.outcome = Outcome::kRefused,
            .reason = "the method tells nothing that the reference of this trial knows"};
  SweepResult result{.figures = FiguresOf(evaluation)};
  AddAdduction(estimate, &result);
  result.trusted = estimate.diagnostics.converged && !estimate.diagnostics.singular;
  if (!result.trusted) result.reason = WhyNotTrusted(estimate.diagnostics);
  return result;
}

}  // namespace

MethodOptions OptionsOf(const SweepTask& task, const std::string& manifest) try {
  std::optional<MethodOptions> method = DefaultOptions(task.method);
  if (!method) throw InputError(manifest, task.index + 1, "no method '" + task.method + "'");
  std::visit(
      [&](auto& options) {
        options.Visit(options, [&](const char* name, auto& field, const char*) {
          task.options.at(name).get_to(field);
        });
      },
      *method);
  return *method;
} catch (const nlohmann::json::exception& error) {
  throw InputError(manifest, task.index + 1, std::string("options: ") + error.what());
}

SweepResult RunSweepTask(const MethodOptions& options, const TrialFolder& folder) try {
  const auto estimator = MakeEstimator(options);
  SweepResult result;
  if (!estimator->Accepts(folder.trial.observations, &result.reason)) {
    result.outcome = Outcome::kRefused;
    return result;
  }
  return Judged(estimator->Run(folder.trial.observations), folder);
} catch (const std::bad_alloc&) {
  return {.outcome = Outcome::kFailed, .reason = "there is not enough memory; try fewer --jobs"};
} catch (const std::exception& error) {
  return {.outcome = Outcome::kFailed, .reason = error.what()};
}

}  // namespace brachium
