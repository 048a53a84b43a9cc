#include "solver/calibrate.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "solver/baselines/static_alignment.h"
#include "solver/calibration_movement.h"
#include "solver/hanging_arm.h"

namespace brachium {
namespace {

using Eigen::Matrix3d, Eigen::Quaterniond, Eigen::Vector3d;
using Movements = std::vector<CalibrationMovement>;

const std::string kPronation = "calibration:forearm_pronation";
const std::string kSupination = "calibration:forearm_supination";
const std::string kEndorotation = "calibration:upper_arm_endorotation";
const std::string kExorotation = "calibration:upper_arm_exorotation";
const std::string kAbduction = "calibration:upper_arm_abduction";

// One segment's calibration in the making.
class Bench {
 public:
  Bench(const Recording& recording, const Observations& observations,
        const CalibrationOptions& options, Calibration& result)
      : recording_(recording),
        observations_(observations),
        limits_{options.least_turn_deg * kDegree, options.largest_misfit_deg * kDegree},
        floor_(options.floor_sigma_deg * kDegree),
        name_(Name(recording.segment)),
        result_(result) {
    found_.segment = recording.segment;
    if (recording.mounting) found_.mounting = *recording.mounting;
  }

  double sign() const { return Sign(observations_.arm.side); }
  const CalibrationLimits& limits() const { return limits_; }

  Movements Measured(const std::string& label) {
    return MeasureMovements(recording_, observations_.intervals, label, limits_, &result_.notes);
  }

  // The same of movements that were labelled for another segment.
  Movements Witnessed(const std::string& label) const {
    std::vector<std::string> faults;
    return MeasureMovements(recording_, observations_.intervals, label, limits_, &faults);
  }

  std::optional<Vector3d> UpWhileHanging() const {
    return UpOfTheHangingArm(recording_, observations_);
  }

  void Note(const std::string& what) { result_.notes.push_back(name_ + ": " + what); }
  void Refuse(const std::string& why) { result_.faults.push_back(name_ + ": " + why); }

  void Add(const std::string& figure, double value) { found_.figures.push_back({figure, value}); }

  // The mean of an axis; absent, and refused, without repetitions that agree.
  bool Agree(const std::string& axis, const std::vector<Vector3d>& told, const std::string& needed,
             MeanDirection& mean) {
    if (told.empty()) return Refuse("no usable " + needed), false;
    mean = Average(told);
    Add(axis + "_repetitions", mean.count);
    Add(axis + "_spread_deg", mean.spread / kDegree);
    if (mean.count == 1)
      Note("one repetition of " + needed + ", so nothing is known of how well it repeats");
    if (mean.worst <= limits_.largest_misfit) return true;
    Refuse("the repetitions of " + needed + " tell directions up to " + Degrees(mean.worst) +
           " from their mean: some turn the other way or about another axis");
    return false;
  }

  // Y is kept, X made square to it.
  void Finish(const MeanDirection& Y, const MeanDirection& X) {
    const double off = AngleBetween(Y.mean, X.mean) - 90 * kDegree;
    Add("x_off_square_deg", off / kDegree);
    if (std::abs(off) > limits_.largest_misfit)
      return Refuse("the direction along the segment and the one across it are " +
                    Degrees(90 * kDegree + off) + " apart; 90 expected");
    Matrix3d R_SB;
    R_SB.col(1) = Y.mean;
    R_SB.col(2) = X.mean.cross(Y.mean).normalized();
    R_SB.col(0) = R_SB.col(1).cross(R_SB.col(2));
    const double of_means = (Y.spread * Y.spread / Y.count + X.spread * X.spread / X.count) / 2;
    Keep(Quaterniond(R_SB).conjugate(), std::sqrt(of_means + floor_ * floor_));
  }

  void Keep(const Quaterniond& q_BS, double sigma) {
    found_.mounting.q_BS = q_BS;
    found_.mounting.q_sigma = sigma;
    result_.segments.push_back(found_);
  }

 private:
  const Recording& recording_;
  const Observations& observations_;
  CalibrationLimits limits_;
  double floor_;
  std::string name_;
  Calibration& result_;
  SegmentCalibration found_;
};

// Labels exchanged, or the wrong side, turn Y and X round together, which pronation and supination
// cannot show. What can: the hanging forearm, where up is Y; and the abduction of a hanging arm whose
// bent forearm points forward, which turns about s Y.
bool PointsToTheElbow(Bench& bench, const MeanDirection& Y) {
  std::vector<std::pair<std::string, double>> witnesses;
  if (const auto up = bench.UpWhileHanging())
    witnesses.push_back({"y_from_vertical_hanging_deg", AngleBetween(*up, Y.mean)});
  std::vector<Vector3d> turns;
  for (const CalibrationMovement& m : bench.Witnessed(kAbduction))
    turns.push_back(bench.sign() * m.axis_S);
  if (!turns.empty())
    witnesses.push_back(
        {"y_from_turn_of_abduction_deg", AngleBetween(Average(turns).mean, Y.mean)});
  if (witnesses.empty())
    bench.Note(
        "nothing shows whether pronation and supination were exchanged or the side is wrong: tell "
        "a "
        "start_pose of a hanging arm, or label it calibration:static_pose");
  for (const auto& [figure, angle] : witnesses) {
    bench.Add(figure, angle / kDegree);
    if (angle < 90 * kDegree) continue;
    bench.Refuse("the direction to the elbow that " + kPronation + " and " + kSupination +
                 " tell points to the hand (" + figure + ": " + Degrees(angle) +
                 "): the two labels are exchanged, or the side is wrong");
    return false;
  }
  return true;
}

void CalibrateForearm(Bench bench) {
  std::vector<Vector3d> along, volar;
  for (const CalibrationMovement& m : bench.Measured(kPronation)) {
    along.push_back(bench.sign() * m.axis_S);
    volar.push_back(-m.up_after_S);
  }
  for (const CalibrationMovement& m : bench.Measured(kSupination)) {
    along.push_back(-bench.sign() * m.axis_S);
    volar.push_back(-m.up_before_S);
  }
  const std::string needed = kPronation + " or " + kSupination;
  MeanDirection Y, X;
  if (bench.Agree("y", along, needed, Y) && bench.Agree("x", volar, needed + " (palm down)", X) &&
      PointsToTheElbow(bench, Y))
    bench.Finish(Y, X);
}

// X from the turning itself: an arm that is abducted turns about -s X.
bool TurnsAsItTilts(Bench& bench, const Movements& abductions, const MeanDirection& X) {
  std::vector<Vector3d> turns;
  for (const CalibrationMovement& m : abductions) turns.push_back(-bench.sign() * m.axis_S);
  const double apart = AngleBetween(Average(turns).mean, X.mean);
  bench.Add("x_of_tilt_from_x_of_turn_deg", apart / kDegree);
  if (apart <= bench.limits().largest_misfit) return true;
  bench.Refuse(kAbduction + " turns the sensor about an axis " + Degrees(apart) +
               " from the one by which gravity tilts in it: it is no abduction of a hanging arm");
  return false;
}

bool HangsAtTheStart(Bench& bench, const Movements& abductions, const MeanDirection& Y) {
  std::vector<Vector3d> up;
  for (const CalibrationMovement& m : abductions) up.push_back(m.up_before_S);
  const double tilt = AngleBetween(Average(up).mean, Y.mean);
  bench.Add("y_from_vertical_before_abduction_deg", tilt / kDegree);
  if (tilt <= bench.limits().largest_misfit) return true;
  bench.Refuse("before " + kAbduction + " the arm's axis is " + Degrees(tilt) +
               " from the vertical; expected a hanging arm. Near 180 deg the side is wrong, or "
               "endorotation and exorotation are exchanged");
  return false;
}

void CalibrateUpperArm(Bench bench) {
  std::vector<Vector3d> along, anterior;
  for (const CalibrationMovement& m : bench.Measured(kEndorotation))
    along.push_back(bench.sign() * m.axis_S);
  for (const CalibrationMovement& m : bench.Measured(kExorotation))
    along.push_back(-bench.sign() * m.axis_S);
  const Movements abductions = bench.Measured(kAbduction);
  for (const CalibrationMovement& m : abductions) {
    const Vector3d tilt = m.up_after_S.cross(m.up_before_S);
    if (tilt.norm() > std::sin(bench.limits().least_turn))
      anterior.push_back(-bench.sign() * tilt.normalized());
  }
  MeanDirection Y, X;
  const bool told = bench.Agree("y", along, kEndorotation + " or " + kExorotation, Y);
  if (!bench.Agree("x", anterior, kAbduction, X) || !told) return;
  if (HangsAtTheStart(bench, abductions, Y) && TurnsAsItTilts(bench, abductions, X))
    bench.Finish(Y, X);
}

std::string MovementsFor(Segment segment) {
  if (segment == Segment::kForearm) return kPronation + " and " + kSupination + " intervals";
  if (segment == Segment::kUpperArm)
    return kEndorotation + ", " + kExorotation + " and " + kAbduction + " intervals";
  return "a calibration:static_pose interval in a recording that carries the maker's orientation "
         "(columns q_*)";
}

void CalibrateWithoutMovements(Bench bench, const Recording& recording,
                               const Observations& unmounted, const CalibrationOptions& options,
                               Calibration& result) {
  const Observations posed = AlignedByStaticPose(unmounted, options.facing_deg * kDegree);
  for (const Recording& other : posed.recordings)
    if (other.segment == recording.segment && other.mounting)
      return bench.Keep(other.mounting->q_BS, options.floor_sigma_deg * kDegree);
  if (recording.mounting)
    result.notes.push_back(std::string(Name(recording.segment)) +
                           ": nothing is labelled for it; the mounting in trial.json is kept");
  else
    bench.Refuse("no mounting in trial.json and no movement to find it from; label " +
                 MovementsFor(recording.segment) + ", or give its q_BS_wxyz");
}

}  // namespace

bool HasLabelledMovements(const Observations& observations, Segment segment) {
  const std::string start = "calibration:" + std::string(Name(segment)) + "_";
  return std::any_of(observations.intervals.begin(), observations.intervals.end(),
                     [&](const Interval& interval) { return interval.label.starts_with(start); });
}

bool CalibrationOptions::IsValid(std::string* why) const {
  if (!(least_turn_deg >= 10.0 && least_turn_deg < 90.0))
    return *why = "least_turn_deg must lie in [10, 90)", false;
  if (!(largest_misfit_deg > 0.0 && largest_misfit_deg < 90.0))
    return *why = "largest_misfit_deg must lie between 0 and 90", false;
  if (!(floor_sigma_deg > 0.0)) return *why = "floor_sigma_deg must be greater than 0", false;
  return true;
}

Calibration Calibrate(const Observations& observations, const CalibrationOptions& options) {
  Calibration result;
  Observations unmounted = observations;
  for (Recording& recording : unmounted.recordings) recording.mounting.reset();
  for (const Recording& recording : observations.recordings) {
    const Bench bench(recording, observations, options, result);
    const bool labelled = HasLabelledMovements(observations, recording.segment);
    if (labelled && recording.segment == Segment::kForearm)
      CalibrateForearm(bench);
    else if (labelled && recording.segment == Segment::kUpperArm)
      CalibrateUpperArm(bench);
    else
      CalibrateWithoutMovements(bench, recording, unmounted, options, result);
  }
  return result;
}

}  // namespace brachium
