#include "io/elbow_check.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "io/elbow_hinge.h"
#include "io/elbow_sensors.h"
#include "io/text.h"
#include "problems/statistics.h"

namespace brachium {
namespace {

constexpr double kLeastMotion = 0.04;        // rms of the force's length about its mean [m/s^2]
constexpr double kWellAgreed = 0.25;         // of that rms: nothing can be much better
constexpr double kHingeFloor = 2 * kDegree;  // misfits below it are all alike [rad]
constexpr std::size_t kHingeWindow = 300;    // instants: 6 s, in which a gyroscope drifts little
constexpr double kLongest = 120.0;           // that is looked at [s]
constexpr double kLongestLag = 3.0;          // [s]
constexpr double kShortestLag = 0.05;        // [s]
// Of the told disagreements, force times hinge, the other ones are at most that. Sound trials: 0.60
// and more, by what skin does to forces at one lag of many; where it is the hinge that gains, 0.97.
// Exchanged sensors: 0.43 at most, in slow movement on much skin.
constexpr double kMuchBetter = 0.52;
constexpr double kBetterByHinge = 0.9;
constexpr double kBeyondSkin = 8 * kDegree;  // of the told misfit, to tell of exchanged sensors
constexpr double kClearMinimum = 0.6;  // of what the hinge is at other clocks, to tell of this one

using Series = std::vector<double>;

// The length of the specific force at the elbow about its mean, which a bias would move.
Series ForceAt(const Eigen::Vector3d& r_S, const ElbowSensor& sensor, double sign) {
  Series lengths;
  for (std::size_t k = 0; k < sensor.gyr_S.size(); ++k)
    lengths.push_back((sign * sensor.acc_S[k] + sensor.Lever(k) * r_S).norm());
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

std::string Shift(std::ptrdiff_t lag) {
  return Fixed(kElbowStep * static_cast<double>(std::abs(lag)), 2) + " s" +
         (lag > 0 ? " late" : " early");
}

// How well the two sensors agree when they are taken for something else, of how they do as told.
struct Agreement {
  double force = 1.0, hinge = 1.0;
  double both() const { return force * hinge; }
};

// Compares what the trial is told to be with what else it could be. Where nothing of its force or
// of its hinge can be compared, that share is 1.
class Comparison {
 public:
  Comparison(const ElbowSensors& sensors, const ArmModel& arm)
      : sensors_(sensors),
        arm_(arm),
        upper_(sensors.upper, sensors.upper.q_BS),
        fore_(sensors.fore, sensors.fore.q_BS),
        force_U_(ForceAt(sensors.upper.elbow_S, sensors.upper, 1.0)),
        force_F_(ForceAt(sensors.fore.elbow_S, sensors.fore, 1.0)),
        motion_(std::max(Rms(force_U_), Rms(force_F_))),
        told_force_(Disagreement(force_U_, force_F_)),
        told_hinge_(Misfit(upper_, fore_, arm, 0)) {}

  bool MovesEnough() const { return motion_ >= kLeastMotion; }
  bool AgreesWell() const { return MovesEnough() && told_force_ < kWellAgreed * motion_; }

  Agreement Exchanged() const {
    const ElbowSensor &upper = sensors_.upper, &fore = sensors_.fore;
    return {Force(ForceAt(upper.elbow_S, fore, 1.0), ForceAt(fore.elbow_S, upper, 1.0), 0),
            Hinge(CarriedSensor(fore, upper.q_BS), CarriedSensor(upper, fore.q_BS))};
  }
  Agreement Turned(double sign_U, double sign_F) const {
    const ElbowSensor &upper = sensors_.upper, &fore = sensors_.fore;
    return {
        Force(ForceAt(upper.elbow_S, upper, sign_U), ForceAt(fore.elbow_S, fore, sign_F), 0),
        Hinge(CarriedSensor(upper, upper.q_BS, sign_U), CarriedSensor(fore, fore.q_BS, sign_F))};
  }
  Agreement Lagging(std::ptrdiff_t lag) const {
    return {Force(force_U_, force_F_, lag), Misfit(upper_, fore_, arm_, lag) / told_hinge_};
  }
  std::string Told() const {
    return "the two sensors disagree about the elbow (its acceleration by " +
           Fixed(told_force_, 2) + " m/s^2 rms, its carrying angle by " +
           Fixed(told_hinge_ / kDegree, 1) + " deg)";
  }

 private:
  static double Misfit(const CarriedSensor& upper, const CarriedSensor& fore, const ArmModel& arm,
                       std::ptrdiff_t lag) {
    if (!arm.elbow.adduction_constraint) return kHingeFloor;
    return std::hypot(kHingeFloor, FitHinge(upper, fore, arm, kHingeWindow, lag).misfit);
  }
  // A misfit that skin may make counts for nothing.
  double Hinge(const CarriedSensor& upper, const CarriedSensor& fore) const {
    const double share = Misfit(upper, fore, arm_, 0) / told_hinge_;
    return told_hinge_ < kBeyondSkin ? std::max(1.0, share) : share;
  }
  double Force(const Series& a, const Series& b, std::ptrdiff_t lag) const {
    return MovesEnough() ? Disagreement(a, b, lag) / told_force_ : 1.0;
  }

  const ElbowSensors& sensors_;
  const ArmModel& arm_;
  CarriedSensor upper_, fore_;
  Series force_U_, force_F_;
  double motion_, told_force_, told_hinge_;
};

struct Suspect {
  Agreement agreement;
  std::string text;
};

Suspect LikeliestClock(const Comparison& comparison) {
  const auto most = static_cast<std::ptrdiff_t>(kLongestLag / kElbowStep);
  const auto least = static_cast<std::ptrdiff_t>(kShortestLag / kElbowStep);
  Suspect best{{HUGE_VAL, HUGE_VAL}, ""};
  std::vector<double> elsewhere;
  for (auto lag = -most; lag <= most; ++lag) {
    if (std::abs(lag) < least) continue;
    const Agreement agreement = comparison.Lagging(lag);
    if (std::abs(lag) > most / 2) elsewhere.push_back(agreement.hinge);
    if (agreement.both() >= best.agreement.both()) continue;
    best.agreement = agreement;
    best.text = "the clock of the forearm looks " + Shift(lag) +
                "; expected one clock: shift its time_s by that [clock]";
  }
  double& hinge = best.agreement.hinge;
  if (hinge > kClearMinimum * Quantile(std::move(elsewhere), 0.5)) hinge = std::max(1.0, hinge);
  return best;
}

std::vector<Suspect> Suspects(const Comparison& comparison) {
  const auto turned = [&](double sign_U, double sign_F, const std::string& which) {
    return Suspect{comparison.Turned(sign_U, sign_F),
                   "acc of " + which +
                       " looks turned round; expected specific force, +9.81 upward at rest: "
                       "multiply it by -1 [gravity_sign]"};
  };
  return {{comparison.Exchanged(),
           "the recordings of upper arm and forearm look exchanged; check which sensor was worn "
           "where [sensors_swapped]"},
          turned(-1.0, 1.0, "the upper arm"),
          turned(1.0, -1.0, "the forearm"),
          turned(-1.0, -1.0, "both sensors"),
          LikeliestClock(comparison)};
}

}  // namespace

bool CheckElbow(const Observations& observations, Findings* findings) {
  const auto sensors = FindElbowSensors(observations, 4.0 * kLongestLag, kLongest);
  if (!sensors) return false;
  const Comparison comparison(*sensors, observations.arm);
  if (comparison.AgreesWell()) return false;
  if (!comparison.MovesEnough() && !observations.arm.elbow.adduction_constraint) return false;
  const std::vector<Suspect> suspects = Suspects(comparison);
  const Suspect& best = *std::ranges::min_element(
      suspects, {}, [](const Suspect& suspect) { return suspect.agreement.both(); });
  const double share = best.agreement.both();
  if (share > (best.agreement.hinge < kBetterByHinge ? kBetterByHinge : kMuchBetter)) return false;
  findings->warnings.push_back(comparison.Told() + ", by " + Fixed(100.0 * share, 0) +
                               " % of that otherwise: " + best.text);
  return true;
}

}  // namespace brachium
