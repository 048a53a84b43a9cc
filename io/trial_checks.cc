#include "io/trial_checks.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/contact_check.h"
#include "io/elbow_check.h"
#include "io/elbow_sensors.h"
#include "io/side_check.h"
#include "io/slip_check.h"
#include "io/text.h"
#include "problems/statistics.h"

namespace brachium {
namespace {

constexpr double kMovingRate = 5 * kDegree;  // rms about the mean [rad/s]
constexpr double kMovingForce = 0.4;         // rms about the mean [m/s^2]

double RmsAboutMean(const std::vector<Eigen::Vector3d>& samples, std::size_t first,
                    std::size_t last) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (std::size_t i = first; i < last; ++i) mean += samples[i];
  const auto count = static_cast<double>(last - first);
  mean /= count;
  double squares = 0.0;
  for (std::size_t i = first; i < last; ++i) squares += (samples[i] - mean).squaredNorm();
  return std::sqrt(squares / count);
}

void CheckRests(const Recording& recording, const std::vector<Interval>& intervals,
                Findings* findings) {
  const auto at = [&](double t) {
    return static_cast<std::size_t>(std::ranges::lower_bound(recording.time, t) -
                                    recording.time.begin());
  };
  for (const Interval& interval : intervals) {
    const std::size_t first = at(interval.start), last = at(interval.end);
    if (interval.label != "rest" || last < first + 3) continue;
    const double rate = RmsAboutMean(recording.gyr_S, first, last);
    const double force = RmsAboutMean(recording.acc_S, first, last);
    if (rate < kMovingRate && force < kMovingForce) continue;
    findings->warnings.push_back(std::string(Name(recording.segment)) + " moves in the rest from " +
                                 Fixed(interval.start, 2) + " to " + Fixed(interval.end, 2) +
                                 " s (" + Fixed(rate / kDegree, 1) + " deg/s and " +
                                 Fixed(force, 2) +
                                 " m/s^2 rms); label only what is still [moving_rest]");
  }
}

// What the accelerometer reads while the sensor hardly turns; nothing where that is not for long.
std::optional<double> RestingForce(const Recording& recording) {
  constexpr double kHardly = 5 * kDegree;  // [rad/s]
  constexpr double kLeast = 1.0;           // [s]
  std::vector<double> forces;
  for (std::size_t i = 0; i < recording.size(); ++i)
    if (recording.gyr_S[i].norm() < kHardly) forces.push_back(recording.acc_S[i].norm());
  if (static_cast<double>(forces.size()) * SamplingPeriod(recording) < kLeast) return std::nullopt;
  return Quantile(std::move(forces), 0.5);
}

void CheckGravity(const Recording& recording, double gravity, Findings* findings) {
  constexpr double kTolerance = 0.35;  // [m/s^2]; sensors in use are off by 0.28
  const auto force = RestingForce(recording);
  if (!force || std::abs(*force - gravity) < kTolerance) return;
  findings->warnings.push_back(std::string(Name(recording.segment)) + ": acc is " +
                               Fixed(*force, 2) + " at rest; expected gravity, " +
                               Fixed(gravity, 2) +
                               " m/s^2: check its unit and its calibration [gravity]");
}

// The mean upward share of gravity, 1 where every orientation is right.
template <typename Reading>
double Uprightness(const Recording& recording, Reading reading) {
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    if (!ShowsOnlyGravity(recording.acc_S[i])) continue;
    sum += (reading(recording.q_WS[i]) * recording.acc_S[i]).normalized().z();
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 1.0;
}

void CheckOrientation(const Recording& recording, Findings* findings) {
  using Eigen::Quaterniond;
  constexpr double kUpright = 0.9;
  if (recording.q_WS.empty()) return;
  const double told = Uprightness(recording, [](const Quaterniond& q) { return q; });
  if (told > kUpright) return;
  const auto w_last = [](const Quaterniond& q) { return Quaterniond(q.z(), q.w(), q.x(), q.y()); };
  const auto inverse = [](const Quaterniond& q) { return q.conjugate(); };
  const std::pair<double, std::string> readings[] = {
      {kUpright, "fits no known convention; expected sensor to world, w first, z up [orientation]"},
      {-told,
       "has z downward, as in north-east-down; expected z up (or acc is turned round) "
       "[orientation_ned]"},
      {Uprightness(recording, w_last),
       "has w last; expected w first: reorder the columns [orientation_w_last]"},
      {Uprightness(recording, inverse),
       "is inverted, world to sensor; expected sensor to world: negate q_x, q_y, q_z "
       "[orientation_inverted]"}};
  const auto& what = std::ranges::max_element(readings, {}, [](const auto& reading) {
                       return reading.first;
                     })->second;
  findings->warnings.push_back(std::string(Name(recording.segment)) +
                               ": the maker's orientation turns gravity to " + Fixed(told, 2) +
                               " of upright; it " + what);
}

// Where a told pose has the arm hang, up must be upward along upper arm and forearm.
void CheckPose(const Observations& observations, const std::optional<HeldPose>& pose,
               const std::string& name, Findings* findings) {
  constexpr double kHanging = 30 * kDegree, kBent = 60 * kDegree, kOpposite = -0.7;
  if (!pose || !pose->shoulder_elevation || *pose->shoulder_elevation > kHanging) return;
  for (const Segment segment : {Segment::kUpperArm, Segment::kForearm}) {
    const Recording* const recording = FindMounted(observations, segment);
    const bool hangs =
        segment == Segment::kUpperArm || (pose->elbow_flexion && *pose->elbow_flexion < kBent);
    if (recording == nullptr || !hangs) continue;
    const auto at = std::ranges::lower_bound(recording->time, pose->time);
    if (at == recording->time.end()) continue;
    const auto i = static_cast<std::size_t>(at - recording->time.begin());
    const double up = (recording->mounting->q_BS * recording->acc_S[i].normalized()).y();
    if (up > kOpposite) continue;
    findings->warnings.push_back(
        std::string(Name(segment)) + ": acc looks turned round: in the " + name +
        ", hanging, it is " + Fixed(up, 2) +
        " of upward; expected specific force, +9.81 upward at rest: multiply it by -1, or turn the "
        "mounting [gravity_sign]");
  }
}

}  // namespace

void CheckTrial(const Observations& observations, Findings* findings) {
  for (const Recording& recording : observations.recordings) {
    CheckRests(recording, observations.intervals, findings);
    CheckOrientation(recording, findings);
    CheckGravity(recording, observations.gravity, findings);
  }
  const std::size_t before = findings->warnings.size();
  CheckPose(observations, observations.start_pose, "start pose", findings);
  CheckPose(observations, observations.end_pose, "end pose", findings);
  CheckContacts(observations, findings);
  if (findings->warnings.size() > before || CheckElbow(observations, findings)) return;
  CheckSide(observations, findings);
  CheckSlip(observations, findings);
}

}  // namespace brachium
