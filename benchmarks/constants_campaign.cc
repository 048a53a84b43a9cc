// Which constants of a trial are worth being estimated: many simulated trials with all errors that are
// usual, each constant held in turn at what was told, and skin followed or not.
//
//   constants_campaign [--seeds=10] [--first_seed=1] [--seconds=120] [--threads=0]
//
// Prints medians of the forearm's error in the upper arm [deg], after one constant rotation on each
// side and as it is. The same flags give the same table.
#include <gflags/gflags.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "bin/in_parallel.h"
#include "problems/alignment.h"
#include "problems/rotation.h"
#include "problems/simulation/simulate.h"
#include "solver/batch_smoother.h"

DEFINE_int32(first_seed, 1, "Of the trials of each kind.");
DEFINE_int32(seeds, 10, "How many trials of each kind.");
DEFINE_double(seconds, 120.0, "Length of a trial.");
DEFINE_int32(threads, 0, "0: as many as the machine has.");

namespace brachium {
namespace {

struct Kind {
  const char* name;
  const char* scenario;
  bool on_skin;
};
constexpr Kind kKinds[] = {{"brisk", "daily_brisk", false},
                           {"slow", "daily_slow", false},
                           {"brisk, skin", "daily_brisk", true},
                           {"slow, skin", "daily_slow", true}};

using Change = std::function<void(Observations&, ModelOptions&)>;

struct Case {
  const char* name;
  Change change;
};

const std::vector<Case>& Cases() {
  static const std::vector<Case> cases = {
      {"by default", [](Observations&, ModelOptions&) {}},
      {"clocks held", [](auto&, ModelOptions& model) { model.clock_offset_sigma_s = 0.0; }},
      {"mountings held", [](auto&, ModelOptions& model) { model.estimate_mountings = false; }},
      {"lever arms held",
       [](Observations& observations, auto&) {
         for (Recording& recording : observations.recordings) recording.mounting->p_sigma = 0.0;
       }},
      {"lengths held",
       [](Observations& observations, auto&) {
         for (auto& [segment, geometry] : observations.arm.segments) geometry.sigma = 0.0;
       }},
      {"gyroscopes' scale held", [](auto&, ModelOptions& model) { model.gyro_scale_sigma = 0.0; }},
      {"accelerometers' scale held",
       [](auto&, ModelOptions& model) { model.accel_scale_sigma = 0.0; }},
      {"accelerometers' bias held",
       [](Observations& observations, auto&) {
         for (Recording& recording : observations.recordings)
           recording.noise.accel_bias_sigma = 0.0;
       }},
      {"carrying angle held",
       [](Observations& observations, auto&) {
         observations.arm.elbow.carrying_angle_sigma = 0.0;
         observations.arm.elbow.carrying_slope_sigma = 0.0;
       }},
      {"skin followed", [](auto&, ModelOptions& model) { model.soft_tissue_deg = 3.0; }},
  };
  return cases;
}

Trial Drawn(const Kind& kind, int seed) {
  ScenarioOptions scenario{.name = kind.scenario, .duration = FLAGS_seconds};
  scenario.seed = static_cast<std::uint64_t>(seed);
  scenario.carrying_angle = ElbowModel{}.carrying_angle;
  scenario.carrying_angle_sd = 5 * kDegree;
  SimulationOptions errors;
  errors.seed = scenario.seed;
  errors.draw_sizes = true;
  errors.scale_error = 0.003;
  errors.misalignment = 0.2 * kDegree;
  errors.mounting_error = 3 * kDegree;
  errors.lever_arm_error = 0.015;
  errors.length_error = 0.008;
  errors.clock_offset = 0.005;
  if (kind.on_skin) errors.soft_tissue = TypicalSoftTissue();
  return Simulate(MakeScenario(scenario), errors).trial;
}

struct Errors {
  double aligned, raw;  // rms [deg]
};

double Rms(const std::vector<Eigen::Quaterniond>& a, const std::vector<Eigen::Quaterniond>& b) {
  double squares = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    squares += Log<double>(a[i].conjugate() * b[i]).squaredNorm();
  return std::sqrt(squares / static_cast<double>(a.size())) / kDegree;
}

Errors ErrorsOf(const Trial& trial, const Change& change) {
  Observations observations = trial.observations;
  SmootherOptions options;
  options.covariance = false;
  change(observations, options.model);
  const Estimate estimate = BatchSmoother(options).Run(observations);
  const auto& truth = trial.reference->q_VB;
  RotationPairs pairs;
  for (std::size_t i = 0; i < estimate.time.size(); ++i) {
    const Eigen::Quaterniond q_UF = estimate.q_WB.at(Segment::kUpperArm)[i].conjugate() *
                                    estimate.q_WB.at(Segment::kForearm)[i];
    if (!q_UF.coeffs().allFinite()) continue;
    pairs.estimate.push_back(q_UF);
    pairs.reference.push_back(truth.at(Segment::kUpperArm)[i].conjugate() *
                              truth.at(Segment::kForearm)[i]);
  }
  return {Rms(AlignBothSides(pairs).Apply(pairs.estimate), pairs.reference),
          Rms(pairs.estimate, pairs.reference)};
}

double Median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

void PrintTable() {
  const auto seeds = static_cast<std::size_t>(FLAGS_seeds);
  std::vector<Trial> trials(std::size(kKinds) * seeds);
  InParallel(trials.size(), FLAGS_threads, [&](std::size_t i) {
    trials[i] = Drawn(kKinds[i / seeds], FLAGS_first_seed + static_cast<int>(i % seeds));
  });
  std::printf("| [deg], aligned / raw |");
  for (const Kind& kind : kKinds) std::printf(" %s |", kind.name);
  std::printf("\n|---|---|---|---|---|\n");
  for (const Case& held : Cases()) {
    std::vector<Errors> errors(trials.size());
    InParallel(trials.size(), FLAGS_threads,
               [&](std::size_t i) { errors[i] = ErrorsOf(trials[i], held.change); });
    std::printf("| %s |", held.name);
    for (std::size_t kind = 0; kind < std::size(kKinds); ++kind) {
      std::vector<double> aligned, raw;
      for (std::size_t i = 0; i < seeds; ++i) {
        aligned.push_back(errors[kind * seeds + i].aligned);
        raw.push_back(errors[kind * seeds + i].raw);
      }
      std::printf(" %.2f / %.1f |", Median(aligned), Median(raw));
    }
    std::printf("\n");
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace brachium

int main(int argc, char** argv) {
  gflags::ParseCommandLineFlags(&argc, &argv, true);
  brachium::PrintTable();
}
