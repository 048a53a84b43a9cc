#include "solver/baselines/heading_corrected.h"

#include <algorithm>
#include <cmath>

#include "problems/sampling.h"
#include "solver/stage_clock.h"
#include "solver/wearing.h"

namespace brachium {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

constexpr double kWindowStep = 0.5;    // from window to window [s]
constexpr double kPostureStep = 0.05;  // between the postures of a window [s]
constexpr double kSteepest = 1e-3;     // least cos β: there a posture says nothing of δ
constexpr double kDamping = 0.01;      // of Gauss-Newton, a rating that is always there
constexpr double kLongestStep = 0.3;   // of Gauss-Newton [rad]
constexpr int kMostSteps = 10;

struct Postures {
  std::vector<double> time;  // [s]
  std::vector<AdductionOfHeading> adduction;
};

Postures PosturesOf(const Estimate& estimate) {
  Postures postures;
  const auto& q_WU = estimate.q_WB.at(Segment::kUpperArm);
  const auto& q_WF = estimate.q_WB.at(Segment::kForearm);
  for (std::size_t i = 0; i < estimate.time.size(); ++i) {
    if (q_WU[i].coeffs().hasNaN() || q_WF[i].coeffs().hasNaN()) continue;
    if (!postures.time.empty() && estimate.time[i] < postures.time.back() + kPostureStep) continue;
    postures.time.push_back(estimate.time[i]);
    postures.adduction.emplace_back(q_WU[i], q_WF[i]);
  }
  return postures;
}

struct Headings {
  std::vector<double> time;     // [s]
  std::vector<double> heading;  // [rad]
  double mean_rating = 0.0;
};

Headings FilterHeadings(const Postures& postures, double adduction,
                        const HeadingCorrectedOptions& options) {
  Headings headings;
  const auto& time = postures.time;
  std::size_t first = 0, last = 0;
  double heading = 0.0;
  for (int k = 0; k * kWindowStep <= time.back() - time.front(); ++k) {
    const double t = time.front() + k * kWindowStep;
    while (time[first] < t - options.heading_window_s / 2) ++first;
    while (last < time.size() && time[last] <= t + options.heading_window_s / 2) ++last;
    const auto* const postures_of_all = postures.adduction.data();
    const HeadingWindow window =
        SolveWindow(postures_of_all + first, postures_of_all + last, adduction, heading);
    const double gain = -std::expm1(-window.rating * kWindowStep / options.heading_time_constant_s);
    heading += gain * (window.heading - heading);
    headings.time.push_back(t);
    headings.heading.push_back(heading);
    headings.mean_rating += window.rating;
  }
  headings.mean_rating /= static_cast<double>(headings.time.size());
  return headings;
}

// Linear between windows; the last one holds to the end.
double HeadingAt(const Headings& headings, double time) {
  const double place = std::max(0.0, (time - headings.time.front()) / kWindowStep);
  const std::size_t before = static_cast<std::size_t>(place);
  if (before + 1 >= headings.heading.size()) return headings.heading.back();
  const double fraction = place - static_cast<double>(before);
  return (1 - fraction) * headings.heading[before] + fraction * headings.heading[before + 1];
}

}  // namespace

AdductionOfHeading::AdductionOfHeading(const Quaterniond& q_WU, const Quaterniond& q_WF) {
  const Vector3d z = q_WU * Vector3d::UnitZ(), y = q_WF * Vector3d::UnitY();
  A = z.z() * y.z();
  B = z.x() * y.x() + z.y() * y.y();
  C = z.y() * y.x() - z.x() * y.y();
}

std::pair<double, double> AdductionOfHeading::At(double heading) const {
  const double c = std::cos(heading), s = std::sin(heading);
  const double sine = std::clamp(A + B * c + C * s, -1.0, 1.0);
  const double cosine = std::sqrt(1 - sine * sine);
  return {std::asin(sine), cosine < kSteepest ? 0.0 : (C * c - B * s) / cosine};
}

HeadingWindow SolveWindow(const AdductionOfHeading* first, const AdductionOfHeading* last,
                          double adduction, double heading) {
  HeadingWindow window{.heading = heading};
  const double count = static_cast<double>(last - first);
  for (int step = 0; step < kMostSteps; ++step) {
    double gradient = 0.0, information = 0.0;
    for (const AdductionOfHeading* posture = first; posture != last; ++posture) {
      const auto [beta, slope] = posture->At(window.heading);
      gradient += slope * (beta - adduction) / count;
      information += slope * slope / count;
    }
    window.rating = information;
    window.heading += std::clamp(-gradient / (information + kDamping), -kLongestStep, kLongestStep);
  }
  return window;
}

bool HeadingCorrectedOptions::IsValid(std::string* why) const {
  if (!(heading_window_s >= kWindowStep))
    return *why = "heading_window_s must be at least 0.5", false;
  if (!(heading_time_constant_s > 0.0))
    return *why = "heading_time_constant_s must be greater than 0", false;
  return filter.IsValid(why);
}

bool HeadingCorrected::Accepts(const Observations& observations, std::string* why) const {
  return IsWholeChain(observations, why) && HasHingedElbow(observations, why);
}

Estimate HeadingCorrected::Run(const Observations& observations, const Progress& progress) const {
  Estimate estimate = LuingeUnconstrained(options_.filter).Run(observations, progress);
  StageClock clock;
  estimate.method = "heading_corrected";
  estimate.sd_B.clear();  // of a heading that is another one now
  const double adduction = -Sign(observations.arm.side) * observations.arm.elbow.carrying_angle;
  const Postures postures = PosturesOf(estimate);
  const Headings headings = FilterHeadings(postures, adduction, options_);
  std::vector<Quaterniond>& q_WF = estimate.q_WB.at(Segment::kForearm);
  for (std::size_t i = 0; i < q_WF.size(); ++i)
    q_WF[i] =
        Quaterniond(Eigen::AngleAxisd(HeadingAt(headings, estimate.time[i]), Vector3d::UnitZ())) *
        q_WF[i];
  estimate.diagnostics.figures.push_back({"mean_heading_rating", headings.mean_rating});
  estimate.timing.push_back({"headings", clock.Lap()});
  return estimate;
}

}  // namespace brachium
