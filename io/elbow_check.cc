#include "io/elbow_check.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "io/text.h"

namespace brachium {
namespace {

constexpr double kStep = 0.02;         // of the common grid [s]
constexpr double kSmoothing = 0.06;    // half the width of the mean over the signals [s]
constexpr double kLeastMotion = 0.04;  // rms of the force's length about its mean [m/s^2]
constexpr double kWellAgreed = 0.25;   // of that rms: nothing can be much better
constexpr double kMuchBetter = 0.55;   // of the told disagreement
constexpr double kLongestLag = 3.0;    // [s]
constexpr double kShortestLag = 0.05;  // [s]

using Series = std::vector<double>;

const Recording* Find(const Observations& observations, Segment segment) {
  for (const Recording& recording : observations.recordings)
    if (recording.segment == segment) return &recording;
  return nullptr;
}

// One sensor on the common grid, each value the mean of the samples around it.
struct Gridded {
  std::vector<Eigen::Vector3d> gyr_S, acc_S;
};

Gridded OnGrid(const Recording& recording, double start, std::size_t size) {
  Gridded grid;
  std::size_t first = 0;
  for (std::size_t k = 0; k < size; ++k) {
    const double t = start + kStep * static_cast<double>(k);
    while (first + 1 < recording.size() && recording.time[first] < t - kSmoothing) ++first;
    Eigen::Vector3d gyr_S = recording.gyr_S[first], acc_S = recording.acc_S[first];
    double count = 1.0;
    for (std::size_t i = first + 1; i < recording.size() && recording.time[i] <= t + kSmoothing;
         ++i, count += 1.0) {
      gyr_S += recording.gyr_S[i];
      acc_S += recording.acc_S[i];
    }
    grid.gyr_S.push_back(gyr_S / count);
    grid.acc_S.push_back(acc_S / count);
  }
  return grid;
}

// The length of the specific force at the elbow about its mean, which a bias would move.
Series ForceAt(const Eigen::Vector3d& r_S, const Gridded& sensor, double sign) {
  Series lengths(sensor.gyr_S.size(), 0.0);
  for (std::size_t k = 1; k + 1 < lengths.size(); ++k) {
    const Eigen::Vector3d& omega_S = sensor.gyr_S[k];
    const Eigen::Vector3d alpha_S = (sensor.gyr_S[k + 1] - sensor.gyr_S[k - 1]) / (2.0 * kStep);
    const Eigen::Vector3d f_S =
        sign * sensor.acc_S[k] + alpha_S.cross(r_S) + omega_S.cross(omega_S.cross(r_S));
    lengths[k] = f_S.norm();
  }
  lengths.front() = lengths[1];
  lengths.back() = lengths[lengths.size() - 2];
  const double mean =
      std::reduce(lengths.begin(), lengths.end()) / static_cast<double>(std::ssize(lengths));
  for (double& length : lengths) length -= mean;
  return lengths;
}

double Rms(const Series& a) {
  double squares = 0.0;
  for (const double value : a) squares += value * value;
  return std::sqrt(squares / static_cast<double>(a.size()));
}

// Rms of a(t) - b(t + lag steps), over where both are.
double Disagreement(const Series& a, const Series& b, std::ptrdiff_t lag = 0) {
  const auto size = std::ssize(a);
  double squares = 0.0, count = 0.0;
  for (auto i = std::max<std::ptrdiff_t>(0, -lag); i < size - std::max<std::ptrdiff_t>(0, lag);
       ++i, count += 1.0) {
    const double difference = a[static_cast<std::size_t>(i)] - b[static_cast<std::size_t>(i + lag)];
    squares += difference * difference;
  }
  return std::sqrt(squares / std::max(count, 1.0));
}

Eigen::Vector3d ElbowFrom(const Mounting& mounting, const Eigen::Vector3d& elbow_B) {
  return mounting.q_BS.conjugate() * (elbow_B - mounting.p_BS_B);
}

struct Suspect {
  double disagreement = 0.0;
  std::string text;
};

std::string Shift(std::ptrdiff_t lag) {
  return Fixed(kStep * static_cast<double>(std::abs(lag)), 2) + " s";
}

// What else the trial could be, and how well each agrees.
std::vector<Suspect> Suspects(const Gridded& upper, const Gridded& fore, const Eigen::Vector3d& r_U,
                              const Eigen::Vector3d& r_F) {
  const Series told_U = ForceAt(r_U, upper, 1.0), told_F = ForceAt(r_F, fore, 1.0);
  const Series turned_U = ForceAt(r_U, upper, -1.0), turned_F = ForceAt(r_F, fore, -1.0);
  std::vector<Suspect> suspects = {
      {Disagreement(ForceAt(r_U, fore, 1.0), ForceAt(r_F, upper, 1.0)),
       "the recordings of upper arm and forearm look exchanged; check which sensor was worn where "
       "[sensors_swapped]"},
      {Disagreement(turned_U, told_F),
       "acc of the upper arm looks turned round; expected specific force, +9.81 upward at rest: "
       "multiply it by -1 [gravity_sign]"},
      {Disagreement(told_U, turned_F),
       "acc of the forearm looks turned round; expected specific force, +9.81 upward at rest: "
       "multiply it by -1 [gravity_sign]"},
      {Disagreement(turned_U, turned_F),
       "acc of both sensors looks turned round; expected specific force, +9.81 upward at rest: "
       "multiply it by -1 [gravity_sign]"}};
  Suspect lagging{HUGE_VAL, ""};
  const auto most = static_cast<std::ptrdiff_t>(kLongestLag / kStep);
  const auto least = static_cast<std::ptrdiff_t>(kShortestLag / kStep);
  for (auto lag = -most; lag <= most; ++lag) {
    const double disagreement = Disagreement(told_U, told_F, lag);
    if (std::abs(lag) < least || disagreement >= lagging.disagreement) continue;
    lagging = {disagreement, "the clock of the forearm looks " + Shift(lag) +
                                 (lag > 0 ? " late" : " early") +
                                 "; expected one clock: shift its time_s by that [clock]"};
  }
  suspects.push_back(lagging);
  return suspects;
}

}  // namespace

bool CheckElbow(const Observations& observations, Findings* findings) {
  const Recording* const upper = Find(observations, Segment::kUpperArm);
  const Recording* const fore = Find(observations, Segment::kForearm);
  if (upper == nullptr || fore == nullptr || !upper->mounting || !fore->mounting) return false;
  const double start = std::max(upper->time.front(), fore->time.front());
  const double end = std::min({upper->time.back(), fore->time.back(), start + 120.0});
  if (end - start < 4.0 * kLongestLag) return false;
  const auto size = static_cast<std::size_t>((end - start) / kStep);
  const Gridded on_upper = OnGrid(*upper, start, size), on_fore = OnGrid(*fore, start, size);
  const Eigen::Vector3d elbow_U = observations.arm.segments.at(Segment::kUpperArm).p_distal_B;
  const Eigen::Vector3d r_U = ElbowFrom(*upper->mounting, elbow_U);
  const Eigen::Vector3d r_F = ElbowFrom(*fore->mounting, Eigen::Vector3d::Zero());
  const Series force_U = ForceAt(r_U, on_upper, 1.0), force_F = ForceAt(r_F, on_fore, 1.0);
  const double motion = std::max(Rms(force_U), Rms(force_F));
  const double told = Disagreement(force_U, force_F);
  if (motion < kLeastMotion || told < kWellAgreed * motion) return false;
  const std::vector<Suspect> suspects = Suspects(on_upper, on_fore, r_U, r_F);
  const Suspect& best = *std::ranges::min_element(suspects, {}, &Suspect::disagreement);
  if (best.disagreement > kMuchBetter * told) return false;
  findings->warnings.push_back("the two sensors disagree about the elbow's acceleration by " +
                               Fixed(told, 2) + " m/s^2 rms, by " + Fixed(best.disagreement, 2) +
                               " otherwise: " + best.text);
  return true;
}

}  // namespace brachium
