#include "io/report/series.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "io/plot/envelope.h"
#include "problems/arm_angles.h"
#include "problems/arm_model.h"

namespace brachium {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::vector<double> InDegrees(std::vector<double> radians) {
  for (double& angle : radians) angle /= kDegree;
  return radians;
}

// Between a segment's y axis and the vertical [deg].
std::vector<double> InclinationOf(const std::vector<Eigen::Quaterniond>& q_WB) {
  std::vector<double> inclination;
  for (const Eigen::Quaterniond& q : q_WB) {
    const Eigen::Vector3d y_W = q * Eigen::Vector3d::UnitY();
    inclination.push_back(std::atan2(y_W.head<2>().norm(), y_W.z()) / kDegree);
  }
  return inclination;
}

// Of that angle [deg], from the standard deviations about the segment's axes as if independent; NaN
// where the axis is upright and tilts to no side.
std::vector<double> InclinationDeviation(const std::vector<Eigen::Quaterniond>& q_WB,
                                         const std::vector<Eigen::Vector3d>& sd_B) {
  std::vector<double> deviation;
  for (std::size_t i = 0; i < sd_B.size(); ++i) {
    const Eigen::Vector3d hinge_W =
        (q_WB[i] * Eigen::Vector3d::UnitY()).cross(Eigen::Vector3d::UnitZ());
    const Eigen::Vector3d hinge_B = q_WB[i].conjugate() * hinge_W / hinge_W.norm();
    deviation.push_back(hinge_B.cwiseProduct(sd_B[i]).norm() / kDegree);
  }
  return deviation;
}

std::vector<Span> RestsOf(const Estimate& estimate, Segment segment) {
  std::vector<Span> rests;
  for (const Rest& rest : estimate.diagnostics.rests)
    if (rest.segment == segment) rests.push_back({rest.start, rest.end});
  return rests;
}

std::vector<Span> Common(const std::vector<Span>& a, const std::vector<Span>& b) {
  std::vector<Span> common;
  for (const Span& x : a)
    for (const Span& y : b)
      if (const Span both{std::max(x.from, y.from), std::min(x.to, y.to)}; both.from < both.to)
        common.push_back(both);
  return common;
}

}  // namespace

std::vector<std::pair<std::string, ShownSeries>> ShownAngles(const Estimate& estimate) {
  std::set<Segment> known;
  for (const auto& [segment, q_WB] : estimate.q_WB) known.insert(segment);
  std::vector<std::pair<std::string, ShownSeries>> shown;
  for (const ArmAngle& angle : ArmAngles(known, estimate.side)) {
    ShownSeries series{.time = estimate.time, .value = InDegrees(SeriesOf(angle, estimate.q_WB))};
    if (const auto sd = estimate.sd_angle.find(angle.name); sd != estimate.sd_angle.end())
      series.sd = InDegrees(sd->second);
    shown.emplace_back(angle.name, std::move(series));
  }
  if (!shown.empty()) return shown;
  for (const auto& [segment, q_WB] : estimate.q_WB) {
    ShownSeries series{.time = estimate.time, .value = InclinationOf(q_WB)};
    if (const auto sd = estimate.sd_B.find(segment); sd != estimate.sd_B.end())
      series.sd = InclinationDeviation(q_WB, sd->second);
    shown.emplace_back(std::string(Name(segment)) + "_inclination", std::move(series));
  }
  return shown;
}

ShownSeries ReferenceAngle(const ReportedEstimate& reported, const std::string& name) {
  if (!reported.evaluation) return {};
  const auto found = reported.evaluation->joint_angles.find(name);
  if (found == reported.evaluation->joint_angles.end()) return {};
  return {.time = reported.evaluation->time, .value = InDegrees(found->second.reference)};
}

std::vector<Span> CommonRests(const Estimate& estimate) {
  std::vector<Span> common;
  bool first = true;
  for (const auto& [segment, q_WB] : estimate.q_WB) {
    const std::vector<Span> rests = RestsOf(estimate, segment);
    common = first ? rests : Common(common, rests);
    first = false;
  }
  return common;
}

void AddWithBand(const ShownSeries& series, const std::string& name, const std::string& band_name,
                 const Stroke& stroke, double factor, std::size_t most, Chart* chart) {
  std::vector<double> low = series.value, high = series.value;
  for (std::size_t i = 0; i < series.sd.size(); ++i)
    if (std::isfinite(series.sd[i])) {
      low[i] -= factor * series.sd[i];
      high[i] += factor * series.sd[i];
    }
  const auto kept = EnvelopeOf(low, high, most);
  const std::vector<double> time = At(kept, series.time);
  chart->lines.push_back({.name = name, .x = time, .y = At(kept, series.value), .stroke = stroke});
  const bool known =
      std::any_of(series.sd.begin(), series.sd.end(), [](double sd) { return std::isfinite(sd); });
  if (!known) return;
  for (std::size_t i = 0; i < series.sd.size(); ++i)
    if (!std::isfinite(series.sd[i])) low[i] = kNaN;
  chart->bands.push_back({.name = band_name,
                          .x = time,
                          .low = At(kept, low),
                          .high = At(kept, high),
                          .fill = {.colour = stroke.colour, .opacity = 0.25}});
}

Chart ChartOverTime(const std::string& title, const std::string& unit,
                    const std::vector<Span>& rests) {
  return {.title = title,
          .x = {.label = "time [s]"},
          .y = {.label = unit},
          .spans_name = "at rest",
          .spans = rests};
}

std::string Spoken(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

}  // namespace brachium
