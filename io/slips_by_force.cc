#include <algorithm>
#include <cmath>
#include <vector>

#include "io/elbow_sensors.h"
#include "io/linear_sums.h"
#include "io/slips.h"

namespace brachium {
namespace {

constexpr double kBlock = 1.0;        // to which the instant of a slip is told [s]
constexpr double kPlaceSigma = 0.1;   // how far a place is looked for [m]
constexpr double kBiasSigma = 0.1;    // of the accelerometers [m/s^2]
constexpr double kShapeSigma = 0.01;  // of their scales and cross-axis sensitivities
constexpr double kCorrelation = 5.0;  // samples that err alike
constexpr double kOutlier = 5.0;      // rms

using Eigen::Index;

// The disagreement about the elbow at an instant, |f_U| - |f_F|, and how it changes with the place
// of the elbow in the axes of either sensor and with the errors of either accelerometer: bias, scale
// of each axis, sensitivity of one axis to the next.
constexpr int kErrors = 9;
struct Instant {
  double time = 0.0;  // [s]
  double residual = 0.0;
  Eigen::Matrix<double, 6, 1> d_place{};
  Eigen::Matrix<double, 2 * kErrors, 1> d_errors{};
};

Instant At(const ElbowSensors& sensors, std::size_t k) {
  Instant instant{.time = sensors.start + kElbowStep * static_cast<double>(k)};
  double sign = 1.0;
  Index which = 0;
  for (const ElbowSensor* sensor : {&sensors.upper, &sensors.fore}) {
    const Eigen::Matrix3d K = sensor->Lever(k);
    const Eigen::Vector3d& acc_S = sensor->acc_S[k];
    const Eigen::Vector3d f_S = acc_S + K * sensor->elbow_S;
    const Eigen::Vector3d along_S = sign * f_S.normalized();
    instant.residual += sign * f_S.norm();
    instant.d_place.segment<3>(3 * which) = K.transpose() * along_S;
    instant.d_errors.segment<kErrors>(kErrors * which) << along_S, along_S.cwiseProduct(acc_S),
        along_S.x() * acc_S.y(), along_S.y() * acc_S.z(), along_S.z() * acc_S.x();
    sign = -1.0;
    ++which;
  }
  return instant;
}

std::vector<Instant> InstantsOf(const ElbowSensors& sensors) {
  std::vector<Instant> instants;
  for (std::size_t k = 0; k < sensors.size(); ++k) instants.push_back(At(sensors, k));
  return instants;
}

// Information of the priors where samples err by `rms`, alike over some of them.
double PriorOf(double sigma, double rms) { return kCorrelation * rms * rms / (sigma * sigma); }

double RmsOf(const std::vector<Instant>& instants) {
  double squares = 0.0;
  for (const Instant& instant : instants) squares += instant.residual * instant.residual;
  return std::sqrt(squares / static_cast<double>(instants.size()));
}

// What one place and constant errors explain is taken off, then what nothing explains.
void TakeOffCommon(std::vector<Instant>& instants) {
  for (int round = 0; round < 2; ++round) {
    const double rms = RmsOf(instants);
    if (round > 0)
      std::erase_if(instants,
                    [rms](const Instant& i) { return std::abs(i.residual) > kOutlier * rms; });
    constexpr int kUnknowns = 6 + 2 * kErrors;
    using Unknowns = Eigen::Matrix<double, kUnknowns, 1>;
    const auto gradient = [](const Instant& instant) {
      Unknowns all;
      all << instant.d_place, instant.d_errors;
      return all;
    };
    Sums<kUnknowns> sums;
    for (const Instant& instant : instants) sums.Add(gradient(instant), instant.residual);
    Unknowns prior = Unknowns::Constant(PriorOf(kShapeSigma, rms));
    prior.head<6>().setConstant(PriorOf(kPlaceSigma, rms));
    for (const Index bias : {6, 6 + kErrors})
      prior.segment<3>(bias).setConstant(PriorOf(kBiasSigma, rms));
    const Unknowns x = sums.Solve(prior);
    for (Instant& instant : instants) instant.residual += gradient(instant).dot(x);
  }
}

// What a place before and another one after explain, of the unknowns that begin at `first`.
template <int kUnknowns>
double Explained(const Sums<6>& before, const Sums<6>& after, Index first, double information,
                 double* change) {
  using Vector = Eigen::Matrix<double, kUnknowns, 1>;
  const auto solve = [&](const Sums<6>& sums) -> Vector {
    Eigen::Matrix<double, kUnknowns, kUnknowns> H =
        sums.A.block<kUnknowns, kUnknowns>(first, first);
    H.diagonal().array() += information;
    return H.ldlt().solve(sums.b.segment<kUnknowns>(first));
  };
  const Vector p = solve(before), q = solve(after);
  *change = (q - p).norm();
  return before.b.segment<kUnknowns>(first).dot(p) + after.b.segment<kUnknowns>(first).dot(q);
}

SlipEvidence SlipAt(const Sums<6>& before, const Sums<6>& after, double squares, double information,
                    double time) {
  double both = 0.0, upper = 0.0, fore = 0.0;
  SlipEvidence slip;
  slip.time = time;
  slip.share = Explained<6>(before, after, 0, information, &both) / squares;
  const bool is_upper = Explained<3>(before, after, 0, information, &upper) >
                        Explained<3>(before, after, 3, information, &fore);
  slip.sensor = is_upper ? "upper_arm" : "forearm";
  slip.change = is_upper ? upper : fore;
  return slip;
}

}  // namespace

std::vector<SlipEvidence> SlipsByForce(const ElbowSensors& sensors) {
  std::vector<Instant> instants = InstantsOf(sensors);
  TakeOffCommon(instants);
  const auto block = [&](double t) {
    return static_cast<std::size_t>((t - sensors.start) / kBlock);
  };
  std::vector<Sums<6>> until(block(instants.back().time) + 2);
  for (const Instant& instant : instants)
    until[block(instant.time) + 1].Add(instant.d_place, instant.residual);
  for (std::size_t i = 1; i < until.size(); ++i) until[i] += until[i - 1];

  std::vector<SlipEvidence> slips;
  const double information = PriorOf(kPlaceSigma, RmsOf(instants));
  const auto least = static_cast<std::size_t>(kLeastPart / kBlock);
  for (std::size_t i = least; i + least < until.size(); ++i)
    slips.push_back(SlipAt(until[i], until.back().Minus(until[i]), until.back().squares,
                           information, sensors.start + kBlock * static_cast<double>(i)));
  return slips;
}

}  // namespace brachium
