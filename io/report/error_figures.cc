#include <algorithm>
#include <cmath>

#include "io/plot/envelope.h"
#include "io/plot/figures.h"
#include "io/plot/palette.h"
#include "io/report/figures.h"
#include "io/report/series.h"
#include "io/text.h"
#include "problems/arm_model.h"
#include "problems/sampling.h"

namespace brachium {
namespace {

constexpr double kBounds = 3.0;         // standard deviations to either side
constexpr std::size_t kMostDots = 500;  // of a chart of differences over means

ShownSeries ErrorOf(const ReportedEstimate& reported, const std::string& name,
                    const JointAngleError& angle) {
  ShownSeries error{.time = reported.evaluation->time};
  for (std::size_t i = 0; i < angle.estimate.size(); ++i)
    error.value.push_back((angle.estimate[i] - angle.reference[i]) / kDegree);
  const auto sd = reported.estimate.sd_angle.find(name);
  if (sd == reported.estimate.sd_angle.end()) return error;
  error.sd = Interpolate(SampleTimes(reported.estimate.time), sd->second, error.time);
  for (double& deviation : error.sd) deviation /= kDegree;
  return error;
}

// "; 98.7 % within 3 sd", or nothing.
std::string ShareWithin(const ShownSeries& error) {
  std::size_t known = 0, within = 0;
  for (std::size_t i = 0; i < error.sd.size(); ++i) {
    if (!std::isfinite(error.value[i]) || !std::isfinite(error.sd[i])) continue;
    ++known;
    within += std::abs(error.value[i]) <= kBounds * error.sd[i];
  }
  if (known == 0) return "";
  return "; " + Fixed(100.0 * static_cast<double>(within) / static_cast<double>(known), 1) +
         " % within 3 sd";
}

// One of the bounds between which the error should stay.
void AddBound(const ShownSeries& error, double factor, const std::string& name, std::size_t most,
              Chart* chart) {
  ShownSeries bound{.time = error.time};
  for (const double sd : error.sd) bound.value.push_back(factor * sd);
  AddWithBand(bound, name, "", {.width = 1.0}, 0.0, most, chart);
}

Chart AngleErrorChart(const ReportedEstimate& reported, const std::string& name,
                      const JointAngleError& angle, std::size_t most) {
  const ShownSeries error = ErrorOf(reported, name, angle);
  Chart chart = ChartOverTime(
      Spoken(name) + ": rmse " + Fixed(angle.rmse / kDegree, 2) + " deg" + ShareWithin(error),
      "error [deg]", CommonRests(reported.estimate));
  AddWithBand({.time = error.time, .value = error.value}, "estimate − reference", "",
              {.colour = SeriesColour(1), .width = 1.2}, 0.0, most, &chart);
  if (!error.sd.empty()) {
    AddBound(error, kBounds, "+3 sd", most, &chart);
    AddBound(error, -kBounds, "−3 sd", most, &chart);
  }
  return chart;
}

Chart DistanceChart(const std::string& title, const std::string& unit,
                    const std::vector<double>& time, const std::vector<double>& distance,
                    double size, std::size_t most, const std::vector<Span>& rests) {
  ShownSeries series{.time = time, .value = distance};
  for (double& value : series.value) value /= size;
  Chart chart = ChartOverTime(title, unit, rests);
  chart.y.from_zero = true;
  AddWithBand(series, "error", "", {.colour = SeriesColour(1), .width = 1.2}, 0.0, most, &chart);
  return chart;
}

Chart AgreementChart(const std::string& name, const JointAngleError& angle) {
  DifferencesOverMeans differences{.title = Spoken(name),
                                   .unit = "deg",
                                   .bias = angle.limits->bias / kDegree,
                                   .lower = angle.limits->lower / kDegree,
                                   .upper = angle.limits->upper / kDegree};
  const std::size_t step = angle.estimate.size() / kMostDots + 1;
  for (std::size_t i = 0; i < angle.estimate.size(); i += step) {
    const double estimate = angle.estimate[i] / kDegree, reference = angle.reference[i] / kDegree;
    differences.mean.push_back((estimate + reference) / 2.0);
    differences.difference.push_back(estimate - reference);
  }
  return BlandAltmanChart(differences);
}

}  // namespace

ReportFigure ErrorsFigure(const ReportedEstimate& reported, std::size_t most) {
  if (!reported.evaluation) return {};
  const Evaluation& evaluation = *reported.evaluation;
  const std::vector<Span> rests = CommonRests(reported.estimate);
  ReportFigure figure{
      .name = "errors",
      .caption =
          "Estimate minus reference at the reference's instants. Black are ±3 standard "
          "deviations as the estimate itself tells them: about 99.7 % of the error should lie "
          "between. Orientations between segments and distances of points are magnitudes; "
          "points after one constant heading and shift."};
  for (const auto& [name, angle] : evaluation.joint_angles)
    if (angle.used > 0) figure.charts.push_back(AngleErrorChart(reported, name, angle, most));
  for (const RelativeEvaluation& relative : evaluation.relative)
    figure.charts.push_back(DistanceChart(Spoken(relative.name), "angle [deg]", evaluation.time,
                                          relative.angle, kDegree, most, rests));
  for (const auto& [name, position] : evaluation.positions)
    figure.charts.push_back(DistanceChart(Spoken(name), "distance [mm]", evaluation.time,
                                          position.distance, 1e-3, most, rests));
  if (figure.charts.empty()) return {};
  figure.size = {.width = 860.0, .height = 230.0};
  figure.svg = DrawCharts(figure.charts, figure.size);
  return figure;
}

ReportFigure AgreementFigure(const ReportedEstimate& reported) {
  if (!reported.evaluation) return {};
  std::vector<std::vector<Chart>> columns(2);
  std::size_t count = 0;
  for (const auto& [name, angle] : reported.evaluation->joint_angles)
    if (angle.limits) columns[count++ % 2].push_back(AgreementChart(name, angle));
  if (count == 0) return {};
  if (count == 1) columns.pop_back();
  return {.name = "agreement",
          .caption =
              "Estimate minus reference over the mean of the two, with the bias and the limits "
              "of agreement (±1.96 sd; Bland and Altman 1986). Limits are of all instants; of "
              "long trials only every so many instants are drawn. Instants of one movement "
              "are not independent.",
          .svg = DrawColumns(columns, {.width = 460.0, .height = 320.0})};
}

}  // namespace brachium
