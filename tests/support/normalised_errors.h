// Errors of an estimate over the standard deviations that it states: of variance one where these can
// be believed. Trials for that, of which all that is wrong is drawn as the estimator is told.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "problems/arm_angles.h"
#include "problems/rotation.h"
#include "problems/simulation/simulate.h"
#include "solver/batch_smoother.h"

namespace brachium {

// A movement, what is wrong with its recordings, and what the estimator holds of both.
struct UncertainCase {
  ScenarioOptions scenario;
  SimulationOptions errors;
  SmootherOptions smoother;
  double told_noise = 1.0;  // times the true noise densities and gyro bias walk
};

// Everything about the sensors, their mounting, the arm and the start is drawn about what is told, at
// the sigma that is told or that the model holds by default. The model is the default one.
inline UncertainCase DrawnAsStated(const std::string& scenario, std::uint64_t seed,
                                   double duration) {
  UncertainCase drawn;
  drawn.scenario = {.name = scenario, .seed = seed, .duration = duration};
  drawn.scenario.side = seed % 2 == 0 ? Side::kLeft : Side::kRight;
  drawn.scenario.carrying_angle = ElbowModel{}.carrying_angle;
  drawn.scenario.carrying_angle_sd = ElbowModel{}.carrying_angle_sigma;
  drawn.scenario.carrying_slope = 0.0;
  drawn.scenario.carrying_slope_sd = ElbowModel{}.carrying_slope_sigma;
  drawn.scenario.adduction_rms = ModelOptions{}.elbow_adduction_sigma_deg * kDegree;
  drawn.scenario.shoulder_rms = ShoulderModel{}.sigma;
  drawn.scenario.exact_rms = false;

  drawn.errors.seed = seed;
  drawn.errors.draw_sizes = true;
  drawn.errors.worn = {Segment::kUpperArm, Segment::kForearm};
  drawn.errors.gyro_bias = MtwNoise().gyro_bias_sigma;
  drawn.errors.accel_bias = MtwNoise().accel_bias_sigma;
  drawn.errors.scale_error = ModelOptions{}.gyro_scale_sigma;
  drawn.errors.misalignment = ModelOptions{}.gyro_cross_axis;
  drawn.errors.clock_offset = ModelOptions{}.clock_offset_sigma_s;
  drawn.errors.mounting_error = Mounting{}.q_sigma;
  drawn.errors.lever_arm_error = Mounting{}.p_sigma;
  drawn.errors.length_error = SegmentGeometry{}.sigma;
  drawn.errors.start_pose_error = HeldPose{}.sigma;

  return drawn;
}

// By quantity, one value per instant (per axis, of a place), in the order in which trials came.
using NormalisedErrors = std::map<std::string, std::vector<double>>;

// The first sample that all sensors cover.
inline std::size_t FirstKnown(const Estimate& estimate) {
  const auto& q_WF = estimate.q_WB.at(Segment::kForearm);
  const auto known = std::find_if(q_WF.begin(), q_WF.end(), [](const Eigen::Quaterniond& q_WB) {
    return q_WB.coeffs().allFinite();
  });
  return static_cast<std::size_t>(known - q_WF.begin());
}

// The reference in the estimate's gauge: the heading of the first segment and the place of the
// shoulder at that sample.
class InGaugeOf {
 public:
  InGaugeOf(const Estimate& estimate, const Reference& reference, std::size_t first)
      : reference_(reference), p_V_(reference.p_V.at("shoulder")[first]) {
    const Eigen::Quaterniond& q_WU = estimate.q_WB.at(Segment::kUpperArm)[first];
    const Eigen::Quaterniond& q_VU = reference.q_VB.at(Segment::kUpperArm)[first];
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d left = Log<double>(q_WU * (q_WV_ * q_VU).conjugate());
      q_WV_ = Exp<double>(Eigen::Vector3d(0.0, 0.0, left.z())) * q_WV_;
    }
  }

  Eigen::Quaterniond Attitude(Segment segment, std::size_t sample) const {
    return q_WV_ * reference_.q_VB.at(segment)[sample];
  }
  Eigen::Vector3d Shoulder(std::size_t sample) const {
    return q_WV_ * (reference_.p_V.at("shoulder")[sample] - p_V_);
  }

 private:
  const Reference& reference_;
  Eigen::Vector3d p_V_;
  Eigen::Quaterniond q_WV_ = Eigen::Quaterniond::Identity();
};

// At these fractions of the trial. Requires an estimate at the reference's times, of an arm with
// upper arm and forearm.
inline void AddNormalisedErrors(const Estimate& estimate, const Reference& reference,
                                const std::vector<double>& fractions, NormalisedErrors& errors) {
  const std::size_t first = FirstKnown(estimate);
  const InGaugeOf truth(estimate, reference, first);
  const auto angles = JointAngleSeries(estimate.q_WB, estimate.side),
             true_angles = JointAngleSeries(reference.q_VB, estimate.side);
  const auto add = [&](const std::string& quantity, double error, double sd) {
    errors[quantity].push_back(error / sd);
  };
  for (const double fraction : fractions) {
    const auto i =
        static_cast<std::size_t>(fraction * static_cast<double>(estimate.time.size() - 1));
    for (const char* angle : {"elbow_flexion", "elbow_carrying", "forearm_pronation"})
      add(angle,
          std::remainder(angles.at(angle)[i] - true_angles.at(angle)[i], 2 * std::numbers::pi),
          estimate.sd_angle.at(angle)[i]);
    const auto off = [&](Segment segment) {
      return estimate.q_WB.at(segment)[i] * truth.Attitude(segment, i).conjugate();
    };
    const Eigen::Vector3d relative =
        Log<double>(off(Segment::kForearm) * off(Segment::kUpperArm).conjugate());
    add("relative_heading", relative.z(), estimate.sd_angle.at("relative_heading")[i]);
    const Eigen::Vector3d displaced =
        estimate.p_W.at("shoulder")[i] - estimate.p_W.at("shoulder")[first] - truth.Shoulder(i);
    for (int axis = 0; axis < 3; ++axis)
      add("shoulder_displacement", displaced[axis], estimate.sd_W.at("shoulder")[i][axis]);
  }
}

inline NormalisedErrors NormalisedErrorsOf(const UncertainCase& drawn,
                                           const std::vector<double>& fractions) {
  NormalisedErrors errors;
  Trial trial = Simulate(MakeScenario(drawn.scenario), drawn.errors).trial;
  for (Recording& recording : trial.observations.recordings) {
    recording.noise.gyro_density *= drawn.told_noise;
    recording.noise.gyro_bias_walk *= drawn.told_noise;
    recording.noise.accel_density *= drawn.told_noise;
  }
  AddNormalisedErrors(BatchSmoother(drawn.smoother).Run(trial.observations), *trial.reference,
                      fractions, errors);
  return errors;
}

inline void Append(const NormalisedErrors& more, NormalisedErrors& errors) {
  for (const auto& [quantity, values] : more)
    errors[quantity].insert(errors[quantity].end(), values.begin(), values.end());
}

inline std::vector<double> Pooled(const NormalisedErrors& errors) {
  std::vector<double> pool;
  for (const auto& [quantity, values] : errors)
    pool.insert(pool.end(), values.begin(), values.end());
  return pool;
}

inline double RmsOf(const std::vector<double>& values) {
  double squares = 0.0;
  for (const double value : values) squares += value * value;
  return std::sqrt(squares / static_cast<double>(values.size()));
}

// The share within the bands that should hold 95 of 100.
inline double Covered(const std::vector<double>& errors) {
  const auto within = std::count_if(errors.begin(), errors.end(),
                                    [](double error) { return std::abs(error) < 1.959964; });
  return static_cast<double>(within) / static_cast<double>(errors.size());
}

}  // namespace brachium
