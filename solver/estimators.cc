#include "solver/estimators.h"

namespace brachium {
namespace {

std::unique_ptr<Estimator> Make(const SmootherOptions& options) {
  return std::make_unique<BatchSmoother>(options);
}
std::unique_ptr<Estimator> Make(const GyroscopeOptions& options) {
  return std::make_unique<GyroscopeOnly>(options);
}
std::unique_ptr<Estimator> Make(const LuingeUnconstrainedOptions& options) {
  return std::make_unique<LuingeUnconstrained>(options);
}
std::unique_ptr<Estimator> Make(const LuingeOptions& options) {
  return std::make_unique<Luinge>(options);
}
std::unique_ptr<Estimator> Make(const LuingeRtsOptions& options) {
  return std::make_unique<Luinge>(options);
}
std::unique_ptr<Estimator> Make(const HeadingCorrectedOptions& options) {
  return std::make_unique<HeadingCorrected>(options);
}
std::unique_ptr<Estimator> Make(const ZhouOptions& options) {
  return std::make_unique<Zhou>(options);
}
std::unique_ptr<Estimator> Make(const BaiKinematicOptions& options) {
  return std::make_unique<BaiKinematic>(options);
}
std::unique_ptr<Estimator> Make(const BaiDeadReckoningOptions& options) {
  return std::make_unique<BaiDeadReckoning>(options);
}
std::unique_ptr<Estimator> Make(const BaiDeadReckoningZuptOptions& options) {
  return std::make_unique<BaiDeadReckoning>(options);
}

}  // namespace

std::optional<MethodOptions> DefaultOptions(const std::string& method) {
  if (method == "smoother") return SmootherOptions{};
  if (method == "gyroscope") return GyroscopeOptions{};
  if (method == "luinge_unconstrained") return LuingeUnconstrainedOptions{};
  if (method == "luinge") return LuingeOptions{};
  if (method == "luinge_rts") return LuingeRtsOptions{};
  if (method == "heading_corrected") return HeadingCorrectedOptions{};
  if (method == "zhou") return ZhouOptions{};
  if (method == "bai_kinematic") return BaiKinematicOptions{};
  if (method == "bai_dead_reckoning") return BaiDeadReckoningOptions{};
  if (method == "bai_dead_reckoning_zupt") return BaiDeadReckoningZuptOptions{};
  return std::nullopt;
}

std::vector<std::string> MethodNames() {
  return {"smoother",
          "gyroscope",
          "luinge_unconstrained",
          "luinge",
          "luinge_rts",
          "heading_corrected",
          "zhou",
          "bai_kinematic",
          "bai_dead_reckoning",
          "bai_dead_reckoning_zupt"};
}

std::unique_ptr<Estimator> MakeEstimator(const MethodOptions& options) {
  return std::visit([](const auto& chosen) { return Make(chosen); }, options);
}

}  // namespace brachium
