// flexion TRIAL_FOLDER: estimates the trial and prints the elbow's flexion, a sample a line.
#include <cstdio>
#include <exception>
#include <numbers>
#include <stdexcept>
#include <string>

#include "io/trial_folder.h"
#include "problems/joint_angles.h"
#include "solver/batch_smoother.h"

namespace {

void PrintFlexion(const std::string& folder) {
  const brachium::Trial trial = brachium::ReadTrial(folder).trial;
  const brachium::BatchSmoother smoother{brachium::SmootherOptions{}};
  if (std::string why; !smoother.Accepts(trial.observations, &why)) throw std::runtime_error(why);
  const brachium::Estimate estimate = smoother.Run(trial.observations);

  const auto& upper_arm = estimate.q_WB.at(brachium::Segment::kUpperArm);
  const auto& forearm = estimate.q_WB.at(brachium::Segment::kForearm);
  std::puts("time_s,elbow_flexion_deg");
  for (std::size_t i = 0; i < estimate.time.size(); ++i) {
    const auto elbow =
        brachium::ElbowAnglesFrom(upper_arm[i].conjugate() * forearm[i], estimate.side);
    std::printf("%.4f,%.3f\n", estimate.time[i], elbow.flexion * 180.0 / std::numbers::pi);
  }
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) throw std::runtime_error("usage: flexion TRIAL_FOLDER");
  PrintFlexion(argv[1]);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "flexion: %s\n", error.what());
  return 1;
}
