#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "io/elbow_hinge.h"
#include "io/linear_sums.h"
#include "io/slips.h"

namespace brachium {
namespace {

constexpr std::size_t kWindow = 600;         // instants: 12 s; gyroscopes drift by few degrees
constexpr double kTurnSigma = 20 * kDegree;  // how far a turn is looked for [rad]
constexpr double kCorrelation = 10.0;        // instants that err alike
constexpr double kElbowSigma = 3 * kDegree;  // what a sound elbow leaves anyway [rad]

using Eigen::Index, Eigen::Matrix3d, Eigen::Vector4d;

// Turns of the upper arm's sensor about x and y and of the forearm's about x and z, segment axes.
struct WindowSums {
  double begin = 0.0, end = 0.0;  // [s]
  Sums<4> turns;
};

// How far e is from what it should be, and how that changes with the turns; the window's heading
// takes off what it explains.
WindowSums SumsOf(const CarriedSensor& upper, const CarriedSensor& fore, const HingeWindow& window,
                  double sine) {
  const Matrix3d level_U = upper.Level(window.first, kWindow).toRotationMatrix();
  const Matrix3d level_F = Eigen::AngleAxisd(window.heading, Eigen::Vector3d::UnitZ()) *
                           fore.Level(window.first, kWindow).toRotationMatrix();
  Sums<5> all;
  for (std::size_t k = window.first; k < window.first + kWindow; k += kHingeEvery) {
    const Matrix3d R_U = level_U * upper.q_0B(k), R_F = level_F * fore.q_0B(k);
    const Matrix3d R_UF = R_U.transpose() * R_F;
    Eigen::Matrix<double, 5, 1> gradient;
    gradient << -R_UF(1, 1), R_UF(0, 1), R_UF(2, 2), -R_UF(2, 0),
        R_U.col(2).dot(Eigen::Vector3d::UnitZ().cross(R_F.col(1)));
    all.Add(gradient, R_UF(2, 1) - sine);
  }
  const Vector4d with_heading = all.A.topRightCorner<4, 1>();
  const double heading = all.A(4, 4) + 1e-9;
  WindowSums sums;
  sums.turns.A = all.A.topLeftCorner<4, 4>() - with_heading * with_heading.transpose() / heading;
  sums.turns.b = all.b.head<4>() - with_heading * all.b(4) / heading;
  sums.turns.squares = all.squares - all.b(4) * all.b(4) / heading;
  return sums;
}

// Of the unknowns from `first` on: what they explain of the squares, and themselves.
template <int kUnknowns>
double Explained(const Sums<4>& sums, Index first, double information,
                 Eigen::Matrix<double, kUnknowns, 1>* turn) {
  Eigen::Matrix<double, kUnknowns, kUnknowns> H = sums.A.block<kUnknowns, kUnknowns>(first, first);
  H.diagonal().array() += information;
  const Eigen::Matrix<double, kUnknowns, 1> b = sums.b.segment<kUnknowns>(first);
  *turn = H.ldlt().solve(b);
  return b.dot(*turn);
}

// What two places explain beyond one, of the unknowns from `first` on, and how far they are apart.
template <int kUnknowns>
double Gain(const Sums<4>& before, const Sums<4>& after, Index first, double information,
            double* apart) {
  Eigen::Matrix<double, kUnknowns, 1> p, q, common;
  Sums<4> both = before;
  both += after;
  const double gain = Explained<kUnknowns>(before, first, information, &p) +
                      Explained<kUnknowns>(after, first, information, &q) -
                      Explained<kUnknowns>(both, first, information, &common);
  *apart = (q - p).norm();
  return gain;
}

SlipEvidence SlipAt(const std::vector<WindowSums>& windows, double time) {
  Sums<4> before, after;
  double instants = 0.0;
  for (const WindowSums& window : windows) {
    if (window.end <= time) before += window.turns;
    if (window.begin >= time) after += window.turns;
    if (window.end <= time || window.begin >= time) instants += kWindow / kHingeEvery;
  }
  const double information =
      kCorrelation * (before.squares + after.squares) / (instants * kTurnSigma * kTurnSigma);
  Sums<4> both = before;
  both += after;
  Vector4d common;
  const double left = both.squares - Explained<4>(both, 0, information, &common);
  double any = 0.0, upper = 0.0, fore = 0.0;
  SlipEvidence slip;
  slip.time = time;
  slip.share =
      Gain<4>(before, after, 0, information, &any) / (left + instants * kElbowSigma * kElbowSigma);
  const bool is_upper = Gain<2>(before, after, 0, information, &upper) >
                        Gain<2>(before, after, 2, information, &fore);
  slip.sensor = is_upper ? "upper_arm" : "forearm";
  slip.change = is_upper ? upper : fore;
  return slip;
}

}  // namespace

std::vector<SlipEvidence> SlipsByHinge(const ElbowSensors& sensors, const ArmModel& arm) {
  if (!arm.elbow.adduction_constraint) return {};
  const CarriedSensor upper(sensors.upper, sensors.upper.q_BS);
  const CarriedSensor fore(sensors.fore, sensors.fore.q_BS);
  const HingeFit fit = FitHinge(upper, fore, arm, kWindow);
  const auto time = [&](std::size_t k) {
    return sensors.start + kElbowStep * static_cast<double>(k);
  };
  std::vector<WindowSums> windows;
  for (const HingeWindow& window : fit.windows) {
    windows.push_back(SumsOf(upper, fore, window, fit.sine));
    windows.back().begin = time(window.first);
    windows.back().end = time(window.first + kWindow);
  }
  std::vector<SlipEvidence> slips;
  for (const WindowSums& window : windows)
    if (window.begin >= time(0) + kLeastPart && window.begin + kLeastPart <= time(upper.size()))
      slips.push_back(SlipAt(windows, window.begin));
  return slips;
}

}  // namespace brachium
