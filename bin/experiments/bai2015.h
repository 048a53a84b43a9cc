// What the tables and the figures of bai2015 share.
#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "bin/experiments/experiment.h"

namespace brachium {

inline const std::vector<std::string> kKinematicMethods = {"bai_kinematic", "smoother"};
inline const std::vector<std::string> kReckoningMethods = {"bai_dead_reckoning",
                                                           "bai_dead_reckoning_zupt", "smoother"};

// The hand's sensor alone: on skin, and as if on a rigid body.
inline const std::vector<std::string> kHandTrials = {"pegs_hand", "pegs_hand_rigid"};

std::vector<int> BaiWeeks(bool quick);  // of the sessions
std::string SessionName(int week);      // 0: the healthy person

// The nine pegs as the hand went in, in Bai's trunk axes: up, backward, right [m].
using PegPlaces = std::array<Eigen::Vector3d, 9>;
PegPlaces TruePegs(const SimulatedTrial& trial);
PegPlaces PegsBy(const ExperimentResults& results, const std::string& trial,
                 const std::string& method);

// Elevation of the upper arm over time and its greatest in each repetition of the abduction test:
// what Bai's Eq. (1) reads [deg].
struct Abduction {
  std::vector<double> time, elevation;
  std::vector<double> reached;
};
Abduction TrueAbduction(const SimulatedTrial& trial);
Abduction AbductionBy(const ExperimentResults& results, const std::string& trial,
                      const std::string& method);

// A point over time in Bai's trunk axes; by a method after one rigid motion of all joints together.
struct TrunkPath {
  std::vector<double> time;
  Eigen::Matrix3Xd p;
};
TrunkPath TruePath(const SimulatedTrial& trial, const std::string& joint);
TrunkPath PathBy(const ExperimentResults& results, const std::string& trial,
                 const std::string& method, const std::string& joint);

std::string SensitivityText(const SimulatedTrial& trial);  // section II.E
std::map<std::string, std::string> BaiFigures(const ExperimentResults& results, bool quick);

}  // namespace brachium
