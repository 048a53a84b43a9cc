#include "solver/estimators.h"

namespace brachium {

std::optional<MethodOptions> DefaultOptions(const std::string& method) {
  if (method == "smoother") return SmootherOptions{};
  return std::nullopt;
}

std::vector<std::string> MethodNames() { return {"smoother"}; }

std::unique_ptr<Estimator> MakeEstimator(const MethodOptions& options) {
  return std::make_unique<BatchSmoother>(std::get<SmootherOptions>(options));
}

}  // namespace brachium
