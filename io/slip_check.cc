#include "io/slip_check.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "io/elbow_sensors.h"
#include "io/text.h"

namespace brachium {
namespace {

constexpr double kBlock = 1.0;          // to which the instant of a slip is told [s]
constexpr double kLeastPart = 8.0;      // of the trial before and after it [s]
constexpr double kLongest = 1200.0;     // [s]
constexpr double kPlaceSigma = 0.1;     // how far a place is looked for [m]
constexpr double kBiasSigma = 0.1;      // of the accelerometers [m/s^2]
constexpr double kShapeSigma = 0.01;    // of their scales and cross-axis sensitivities
constexpr double kCorrelation = 5.0;    // samples that err alike
constexpr double kLeastChange = 0.015;  // of the elbow in the sensor's axes [m]
// Share of the disagreement that two places must explain: chance and soft tissue explain the more,
// the shorter the trial (up to 14 % of a minute).
constexpr double kLeastShare = 0.12;
constexpr double kChance = 5.0;   // [s], over the length of the trial
constexpr double kOutlier = 5.0;  // rms

using Eigen::Index;

// Sums of a linear least-squares problem: matrix, vector, squares.
template <int kSize>
struct Sums {
  Eigen::Matrix<double, kSize, kSize> A = Eigen::Matrix<double, kSize, kSize>::Zero();
  Eigen::Matrix<double, kSize, 1> b = Eigen::Matrix<double, kSize, 1>::Zero();
  double squares = 0.0;

  void Add(const Eigen::Matrix<double, kSize, 1>& gradient, double residual) {
    A += gradient * gradient.transpose();
    b -= gradient * residual;
    squares += residual * residual;
  }
  Sums& operator+=(const Sums& other) {
    A += other.A;
    b += other.b;
    squares += other.squares;
    return *this;
  }
  Sums Minus(const Sums& other) const {
    Sums rest = *this;
    rest.A -= other.A;
    rest.b -= other.b;
    rest.squares -= other.squares;
    return rest;
  }
  // The unknowns that explain most, beside a prior of zero with this information.
  Eigen::Matrix<double, kSize, 1> Solve(const Eigen::Matrix<double, kSize, 1>& prior) const {
    Eigen::Matrix<double, kSize, kSize> H = A;
    H.diagonal() += prior;
    return H.ldlt().solve(b);
  }
};

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

struct Slip {
  double time = 0.0;       // [s]
  double explained = 0.0;  // share of the squares
  std::string sensor;      // that explains more alone
  double change = 0.0;     // of the elbow's place in its axes [m]
};

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

// The instant at which a place before it and another one after it explain most.
Slip LikeliestSlip(const std::vector<Instant>& instants) {
  const double start = instants.front().time;
  const auto block = [start](double t) { return static_cast<std::size_t>((t - start) / kBlock); };
  std::vector<Sums<6>> until(block(instants.back().time) + 2);
  for (const Instant& instant : instants)
    until[block(instant.time) + 1].Add(instant.d_place, instant.residual);
  for (std::size_t i = 1; i < until.size(); ++i) until[i] += until[i - 1];

  Slip best;
  const double information = PriorOf(kPlaceSigma, RmsOf(instants));
  const auto least = static_cast<std::size_t>(kLeastPart / kBlock);
  for (std::size_t i = least; i + least < until.size(); ++i) {
    const Sums<6> after = until.back().Minus(until[i]);
    double both = 0.0, upper = 0.0, fore = 0.0;
    const double explained =
        Explained<6>(until[i], after, 0, information, &both) / until.back().squares;
    if (explained <= best.explained) continue;
    const bool is_upper = Explained<3>(until[i], after, 0, information, &upper) >
                          Explained<3>(until[i], after, 3, information, &fore);
    best = {start + kBlock * static_cast<double>(i), explained, is_upper ? "upper_arm" : "forearm",
            is_upper ? upper : fore};
  }
  return best;
}

}  // namespace

void CheckSlip(const Observations& observations, Findings* findings) {
  const auto sensors = FindElbowSensors(observations, 2.0 * kLeastPart + 1.0, kLongest);
  if (!sensors) return;
  std::vector<Instant> instants = InstantsOf(*sensors);
  TakeOffCommon(instants);
  const Slip slip = LikeliestSlip(instants);
  const double length = instants.back().time - instants.front().time;
  if (slip.explained < kLeastShare + kChance / length || slip.change < kLeastChange) return;
  findings->warnings.push_back(slip.sensor + ": from about " + Fixed(slip.time, 0) +
                               " s on the sensor sits otherwise (" + Fixed(100.0 * slip.change, 0) +
                               " cm, seen from the elbow); if it slipped, make two trials of this "
                               "one [slip]");
}

}  // namespace brachium
