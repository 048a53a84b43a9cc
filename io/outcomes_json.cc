#include "io/outcomes_json.h"

#include <string>
#include <vector>

#include "problems/arm_model.h"
#include "problems/statistics.h"

namespace brachium {
namespace {

using Json = nlohmann::ordered_json;  // a number that is NaN becomes null

Json OrNull(const std::optional<double>& value, double unit) {
  return value ? Json(*value / unit) : Json(nullptr);
}

Json EpochJson(const MovementEpoch& epoch, bool is_point) {
  const double unit = is_point ? 1.0 : kDegree;
  return {{"start_s", epoch.start},
          {"end_s", epoch.end},
          {is_point ? "peak_speed_m_s" : "peak_rate_deg_s", epoch.peak_speed / unit},
          {"time_to_peak_s", epoch.time_to_peak},
          {"speed_peaks", epoch.speed_peaks},
          {"sparc", epoch.spectral_arc_length},
          {"ldlj", epoch.log_jerk},
          {is_point ? "path_m" : "path_deg", epoch.path / unit},
          {"path_ratio", OrNull(epoch.path_ratio, 1.0)}};
}

template <typename Of>
double Median(const std::vector<MovementEpoch>& epochs, const Of& of) {
  std::vector<double> values;
  for (const MovementEpoch& epoch : epochs) values.push_back(of(epoch));
  return Quantile(values, 0.5);
}

Json MovementJson(const MovementOutcomes& outcomes) {
  const double unit = outcomes.is_point ? 1.0 : kDegree;
  const auto median = [&](auto of) { return Median(outcomes.epochs, of); };
  Json epochs = Json::array();
  double moving = 0.0;
  for (const MovementEpoch& epoch : outcomes.epochs) {
    moving += epoch.end - epoch.start;
    epochs.push_back(EpochJson(epoch, outcomes.is_point));
  }
  return {{"of", outcomes.mover},
          {"count", outcomes.epochs.size()},
          {"moving_s", moving},
          {"median_duration_s", median([](const auto& e) { return e.end - e.start; })},
          {outcomes.is_point ? "median_peak_speed_m_s" : "median_peak_rate_deg_s",
           median([&](const auto& e) { return e.peak_speed / unit; })},
          {"median_speed_peaks", median([](const auto& e) { return 1.0 * e.speed_peaks; })},
          {"median_sparc", median([](const auto& e) { return e.spectral_arc_length; })},
          {"median_ldlj", median([](const auto& e) { return e.log_jerk; })},
          {"median_path_ratio",
           median([](const auto& e) { return e.path_ratio.value_or(Statistics::kUnknown); })},
          {"epochs", epochs}};
}

}  // namespace

Json ToJson(const MovementOutcomes& outcomes) {
  Json ranges = Json::object();
  for (const auto& [name, range] : outcomes.ranges)
    ranges[name] = {{"least_deg", range.least / kDegree},
                    {"greatest_deg", range.greatest / kDegree},
                    {"range_deg", (range.greatest - range.least) / kDegree}};
  return {{"movement", MovementJson(outcomes)},
          {"ranges", ranges},
          {"compensation",
           {{"shoulder_range_m", OrNull(outcomes.shoulder_range, 1.0)},
            {"trunk_tilt_deg", OrNull(outcomes.trunk_tilt, kDegree)}}}};
}

}  // namespace brachium
