#include "solver/diagnosis.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "solver/residual_sums.h"

namespace brachium {
namespace {

std::size_t U(int i) { return static_cast<std::size_t>(i); }

// A standard deviation above this share of its prior's has learned nothing worth the name.
constexpr double kUninformed = 0.95;

// Standard deviations that a constant may move away from its prior without a word.
constexpr double kFar = 4.0;

std::string SegmentName(const ArmProblem& problem, int sensor) {
  return std::string(Name(problem.observations().recordings[U(sensor)].segment));
}

std::string PlaceName(const ArmProblem& problem, const Unknown& unknown) {
  return problem.observations().contacts[U(unknown.sensor)].place;
}

constexpr double kNoPrior = std::numeric_limits<double>::infinity();

// How a constant is called in results, and what its prior's sd is; both in that unit.
struct ConstantEntry {
  std::string name;
  std::vector<double> prior_sd;
  double unit = 1.0;
};

std::optional<ConstantEntry> Describe(const ArmProblem& problem, const Unknown& unknown) {
  if (unknown.held) return std::nullopt;
  const Observations& observations = problem.observations();
  const auto named = [&](const char* name, double sigma) {
    return ConstantEntry{SegmentName(problem, unknown.sensor) + "." + name, {sigma, sigma, sigma}};
  };
  switch (unknown.kind) {
    case UnknownKind::kGyroScale:
      return named("gyroscope_scale", problem.options().gyro_scale_sigma);
    case UnknownKind::kAccelBias:
      return named("accelerometer_bias_m_s2",
                   observations.recordings[U(unknown.sensor)].noise.accel_bias_sigma);
    case UnknownKind::kAccelScale:
      return named("accelerometer_scale", problem.options().accel_scale_sigma);
    case UnknownKind::kSensorPosition:
      return named("p_BS_m", observations.recordings[U(unknown.sensor)].mounting->p_sigma);
    case UnknownKind::kJointVector:
      return named(
          "distal_joint_m",
          observations.arm.segments.at(observations.recordings[U(unknown.sensor)].segment).sigma);
    case UnknownKind::kClockOffset:
      return ConstantEntry{SegmentName(problem, unknown.sensor) + ".clock_offset_s",
                           {problem.options().clock_offset_sigma_s}};
    case UnknownKind::kMounting: {
      const double sigma = observations.recordings[U(unknown.sensor)].mounting->q_sigma / kDegree;
      return ConstantEntry{SegmentName(problem, unknown.sensor) + ".mounting_turn_deg",
                           {sigma, sigma, sigma},
                           kDegree};
    }
    case UnknownKind::kShoulderMean: {
      const double sigma = observations.arm.shoulder.sigma;
      return ConstantEntry{"shoulder.mean_m", {sigma, sigma, sigma}};
    }
    case UnknownKind::kContactPlace:
      return ConstantEntry{"contact." + PlaceName(problem, unknown) + "_m",
                           {kNoPrior, kNoPrior, kNoPrior}};
    case UnknownKind::kContactHeight:
      return ConstantEntry{"contact." + PlaceName(problem, unknown) + "_height_m", {kNoPrior}};
    default:
      return std::nullopt;
  }
}

std::string Seconds(double start, double end) {
  char text[64];
  std::snprintf(text, sizeof text, "%.1f-%.1f s", start, end);
  return text;
}

// "x, z" for the components whose sd stayed at its prior.
std::string UninformedAxes(const Eigen::VectorXd& sd, const std::vector<double>& prior_sd) {
  std::string axes;
  for (Eigen::Index i = 0; i < sd.size(); ++i) {
    if (sd[i] < kUninformed * prior_sd[static_cast<std::size_t>(i)]) continue;
    if (!axes.empty()) axes += ", ";
    axes += "xyz"[i];
  }
  return axes;
}

}  // namespace

std::vector<ResidualStatistics> DescribeResiduals(const ArmProblem& problem, State& state) {
  ResidualSums sums;
  sums.Add(problem, state, 0, problem.size().knots);
  return sums.Statistics();
}

std::vector<Constant> DescribeConstants(const ArmProblem& problem, const State& state,
                                        const Certainty& certainty) {
  std::vector<Constant> constants;
  for (int unknown = problem.FirstConstant(); unknown < problem.unknowns(); ++unknown) {
    const Unknown u = problem.Describe(unknown);
    const double* x = state.Constant(u.kind, u.sensor);
    const auto found = certainty.constant_sd.find(unknown);
    const auto add = [&](const std::string& name, int first, int count, double unit) {
      Constant constant{name, {}, {}};
      for (int i = first; i < first + count; ++i) {
        constant.value.push_back(x[i] / unit);
        if (found != certainty.constant_sd.end()) constant.sd.push_back(found->second[i] / unit);
      }
      constants.push_back(constant);
    };
    if (u.kind == UnknownKind::kCarryingAngle) {
      add("elbow.carrying_angle_deg", 0, 1, kDegree);
      add("elbow.carrying_slope_deg", 1, 1, kDegree);
    } else if (const auto entry = Describe(problem, u)) {
      add(entry->name, 0, static_cast<int>(entry->prior_sd.size()), entry->unit);
    }
  }
  for (int sensor = 0; sensor < problem.size().sensors; ++sensor) {
    constants.push_back({SegmentName(problem, sensor) + ".unmodelled_acceleration_m_s2",
                         {problem.unmodelled()[U(sensor)].acceleration},
                         {}});
    constants.push_back({SegmentName(problem, sensor) + ".unmodelled_quiver_m",
                         {problem.unmodelled()[U(sensor)].quiver},
                         {}});
  }
  return constants;
}

std::vector<std::string> ConstantsHeldByPrior(const ArmProblem& problem, const Certainty& certainty,
                                              double start, double end) {
  std::vector<std::string> sentences;
  const std::string whole = Seconds(start, end);
  for (const auto& [unknown, sd] : certainty.constant_sd) {
    const Unknown u = problem.Describe(unknown);
    if (u.held || u.kind == UnknownKind::kGyroBias) continue;
    const auto entry = Describe(problem, u);
    if (u.kind == UnknownKind::kCarryingAngle) {
      const ElbowModel& elbow = problem.observations().arm.elbow;
      if (sd[0] > kUninformed * elbow.carrying_angle_sigma)
        sentences.push_back("elbow.carrying_angle_deg, " + whole);
      if (sd[1] > kUninformed * elbow.carrying_slope_sigma)
        sentences.push_back("elbow.carrying_slope_deg, " + whole);
    } else if (entry) {
      const std::string axes = UninformedAxes(sd / entry->unit, entry->prior_sd);
      if (!axes.empty()) sentences.push_back(entry->name + " (" + axes + "), " + whole);
    }
  }
  return sentences;
}

std::vector<std::string> HeldByPrior(const ArmProblem& problem, const Certainty& certainty) {
  const Timeline& timeline = problem.timeline();
  const double start = timeline.knots.front(), end = timeline.knots.back();
  const std::string whole = Seconds(start, end);
  std::vector<std::string> sentences = ConstantsHeldByPrior(problem, certainty, start, end);
  for (int sensor = 0; sensor < problem.size().sensors; ++sensor) {
    const double sigma = problem.observations().recordings[U(sensor)].noise.gyro_bias_sigma;
    for (int node = 0; node < problem.size().nodes; ++node) {
      const auto& sd = certainty.constant_sd.at(problem.GyroBias(node, sensor));
      const int first = node;
      if (UninformedAxes(sd, {sigma, sigma, sigma}).empty()) continue;
      const std::string axes = UninformedAxes(sd, {sigma, sigma, sigma});
      while (node + 1 < problem.size().nodes &&
             !UninformedAxes(certainty.constant_sd.at(problem.GyroBias(node + 1, sensor)),
                             {sigma, sigma, sigma})
                  .empty())
        ++node;
      sentences.push_back(SegmentName(problem, sensor) + ".gyro_bias (" + axes + "), " +
                          Seconds(timeline.NodeTime(first), timeline.NodeTime(node)));
    }
  }
  for (int sensor = 1; sensor < problem.size().sensors; ++sensor)
    if (certainty.start_heading_sd[U(sensor)] > kUninformed * ArmProblem::kStartHeadingSigma)
      sentences.push_back("heading of the " + SegmentName(problem, sensor) + " against the " +
                          SegmentName(problem, sensor - 1) + ", " + whole);
  if (problem.size().sensors == 1) {
    sentences.push_back("heading of the " + SegmentName(problem, 0) +
                        ", of which one sensor alone knows only the changes, " + whole);
    return sentences;
  }
  const double sigma = problem.observations().arm.shoulder.sigma;
  for (int knot = 0; knot < problem.size().knots; ++knot) {
    const int first = knot;
    while (knot < problem.size().knots && certainty.root_sd[U(knot)] > kUninformed * sigma) ++knot;
    if (knot - first > 1 && timeline.knots[U(knot) - 1] - timeline.knots[U(first)] > 1.0)
      sentences.push_back("position of the arm's root, " +
                          Seconds(timeline.knots[U(first)], timeline.knots[U(knot) - 1]));
  }
  return sentences;
}

std::vector<std::string> FarFromTold(const ArmProblem& problem, const State& state) {
  std::vector<std::string> sentences;
  const State told = problem.PriorState();
  for (int unknown = problem.FirstConstant(); unknown < problem.unknowns(); ++unknown) {
    const Unknown u = problem.Describe(unknown);
    const auto entry = Describe(problem, u);
    if (!entry) continue;
    const double* x = state.Constant(u.kind, u.sensor);
    const double* x_told = told.Constant(u.kind, u.sensor);
    for (std::size_t i = 0; i < entry->prior_sd.size(); ++i) {
      const double found = x[i] / entry->unit, expected = x_told[i] / entry->unit;
      const double sigmas = std::abs(found - expected) / entry->prior_sd[i];
      if (sigmas < kFar) continue;
      char text[200];
      std::snprintf(text, sizeof text,
                    "%s (%c) is found at %.4g where %.4g was told: %.1f of its standard deviations "
                    "off. Check it; if it is right, distrust this result",
                    entry->name.c_str(), "xyz"[i], found, expected, sigmas);
      sentences.push_back(text);
    }
  }
  return sentences;
}

std::vector<Rest> DescribeRests(const ArmProblem& problem) {
  std::vector<Rest> rests;
  for (int sensor = 0; sensor < problem.size().sensors; ++sensor)
    for (const RestInterval& rest : problem.Rests(sensor))
      rests.push_back({problem.observations().recordings[U(sensor)].segment, rest.start, rest.end,
                       rest.probability});
  return rests;
}

}  // namespace brachium
