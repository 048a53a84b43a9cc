#include "solver/self_calibrate.h"

#include <algorithm>
#include <cmath>

#include "problems/joint_angles.h"
#include "problems/statistics.h"
#include "solver/ball_joint.h"
#include "solver/calibration_movement.h"
#include "solver/hinge_axes.h"

namespace brachium {
namespace {

using Eigen::Matrix3d, Eigen::Quaterniond, Eigen::Vector3d;

constexpr double kShortest = 10.0;                   // [s]
constexpr double kLeastRange = 30 * kDegree;         // of flexion and of pronation
constexpr double kLeastKnownAxis = 18 * kDegree;     // sd
constexpr double kLeastKnownHeading = 15 * kDegree;  // sd
constexpr double kLineSigma = 5 * kDegree;           // the shoulder is no point, and skin gives way
constexpr double kSeatSigma =
    20 * kDegree;  // from the forearm's axis to its sensor, seen from the elbow
constexpr double kStretched = -5 * kDegree;  // the least flexion of a usual elbow
constexpr double kHangs = 35 * kDegree;
constexpr double kAssumedPoseSigma = 30 * kDegree;
constexpr double kPlaceSigma = 0.01;  // [m]

// The segments' axes in the axes of their sensors, and what is known of them.
struct Elbow {
  Matrix3d R_AU, R_BF;
  double flexion_zero_sd = 0.0, pronation_zero_sd = 0.0;  // [rad]
};

Matrix3d FromYZ(const Vector3d& Y, const Vector3d& Z) {
  Matrix3d R;
  R << Y.cross(Z), Y, Z;
  return R;
}

// What the places of the joints and the usual elbow say of the axes.
HingeAnatomy AnatomyOf(const BallJoint& joint, const ElbowModel& elbow, Side side) {
  const double line_sd = joint.upper_sd / joint.shoulder_to_elbow_A.norm();
  return {.to_shoulder_A = -joint.shoulder_to_elbow_A.normalized(),
          .to_shoulder_sd = std::hypot(line_sd, kLineSigma),
          .to_elbow_B = -joint.elbow_to_sensor_B.normalized(),
          .to_elbow_sd = kSeatSigma,
          .beta = -Sign(side) * elbow.carrying_angle,
          .beta_sd = elbow.carrying_angle_sigma};
}

// The zero of flexion from the line to the shoulder; that of pronation is left open.
Elbow FromAxes(const HingeAxes& axes, const Vector3d& line_A) {
  const Vector3d Y_U = (line_A - line_A.dot(axes.j1_A) * axes.j1_A).normalized();
  return {.R_AU = FromYZ(Y_U, axes.j1_A), .R_BF = FromYZ(axes.j2_B, axes.j2_B.unitOrthogonal())};
}

ElbowAngles AnglesAt(const Elbow& elbow, const Matrix3d& R_AB, Side side) {
  return ElbowAnglesFrom(Quaterniond(Matrix3d(elbow.R_AU.transpose() * R_AB * elbow.R_BF)), side);
}

Vector3d UpAtTheStart(const Recording& recording, double until) {
  Vector3d force = Vector3d::Zero();
  for (std::size_t i = 0; i < recording.size() && recording.time[i] <= until; ++i)
    force += recording.acc_S[i];
  return force.normalized();
}

class SelfCalibration {
 public:
  SelfCalibration(const Observations& observations, const CalibrationOptions& options)
      : observations_(observations), floor_(options.floor_sigma_deg * kDegree) {}

  Calibration Run() {
    const Recording* upper_arm = RecordingOf(Segment::kUpperArm);
    const Recording* forearm = RecordingOf(Segment::kForearm);
    if (upper_arm && forearm) CalibrateElbow(*upper_arm, *forearm);
    for (const Recording& other : observations_.recordings)
      if (&other != upper_arm && &other != forearm && !other.mounting)
        result_.notes.push_back(std::string(Name(other.segment)) +
                                ": the elbow tells nothing of its mounting, and it is left out; to "
                                "keep it, give its q_BS_wxyz");
    return result_;
  }

 private:
  const Recording* RecordingOf(Segment segment) {
    for (const Recording& recording : observations_.recordings)
      if (recording.segment == segment) return &recording;
    Refuse(std::string(Name(segment)) + " has no recording; both sides of the elbow are needed");
    return nullptr;
  }

  void CalibrateElbow(const Recording& upper_arm, const Recording& forearm) {
    std::string why;
    const auto joint = FollowBallJoint(upper_arm, forearm, side(), &why);
    if (!joint) return Refuse(why);
    if (joint->time.back() - joint->time.front() < kShortest)
      return Refuse("both sensors together cover less than 10 s: record 10 s or more of movement");
    const HingeAnatomy anatomy = AnatomyOf(*joint, observations_.arm.elbow, side());
    const HingeAxes axes = FindHingeAxes(joint->R_AB, BallJoint::kPeriod, anatomy);
    Elbow elbow = FromAxes(axes, anatomy.to_shoulder_A);
    const auto pose = PoseFor(elbow, *joint, upper_arm, forearm);
    if (pose) SetZeros(*pose, *joint, elbow);
    KeepFromOverstretching(*joint, elbow);
    const std::vector<Figure> ranges = Ranges(*joint, elbow);
    if (!IsTold(*joint, axes, ranges)) return;
    if (!pose)
      return Refuse(
          "nothing tells the zero of pronation, which no movement shows: tell a start_pose "
          "(arms_along_body_thumbs_forward), or begin with a hanging arm, thumb forward");
    Keep(upper_arm, *joint, axes, elbow);
    Keep(forearm, *joint, axes, elbow);
    for (const Figure& range : ranges) result_.segments.back().figures.push_back(range);
    TellLimits(*pose);
  }

  // The told start pose; else that of a hanging arm, where the recordings begin with one.
  std::optional<StartPose> PoseFor(const Elbow& elbow, const BallJoint& joint,
                                   const Recording& upper_arm, const Recording& forearm) {
    if (observations_.start_pose && observations_.start_pose->forearm_pronation)
      return observations_.start_pose;
    const double begin = joint.time.front();
    const Vector3d up_A = UpAtTheStart(upper_arm, begin + 0.5);
    const Vector3d up_B = UpAtTheStart(forearm, begin + 0.5);
    if (AngleBetween(up_A, elbow.R_AU.col(1)) > kHangs ||
        AngleBetween(up_B, elbow.R_BF.col(1)) > kHangs)
      return std::nullopt;
    assumed_ = true;
    return StartPose{.time = begin + 0.25,
                     .elbow_flexion = 10 * kDegree,
                     .forearm_pronation = 90 * kDegree,
                     .shoulder_elevation = {},
                     .sigma = kAssumedPoseSigma};
  }

  void SetZeros(const StartPose& pose, const BallJoint& joint, Elbow& elbow) {
    const auto after = std::lower_bound(joint.time.begin(), joint.time.end(), pose.time);
    const auto last = static_cast<std::ptrdiff_t>(joint.time.size()) - 1;
    const auto at = static_cast<std::size_t>(std::min(after - joint.time.begin(), last));
    const ElbowAngles now = AnglesAt(elbow, joint.R_AB[at], side());
    const double line = std::hypot(joint.upper_sd / joint.shoulder_to_elbow_A.norm(), kLineSigma);
    const double weight_of_line = 1 / (line * line);
    const double weight_of_pose = pose.elbow_flexion ? 1 / (pose.sigma * pose.sigma) : 0.0;
    const double weights = weight_of_line + weight_of_pose;
    const double further = pose.elbow_flexion.value_or(now.flexion) - now.flexion;
    elbow.R_AU *= Eigen::AngleAxisd(-further * weight_of_pose / weights, Vector3d::UnitZ())
                      .toRotationMatrix();
    elbow.flexion_zero_sd = 1 / std::sqrt(weights);
    const double turn = Sign(side()) * (*pose.forearm_pronation - now.pronation);
    elbow.R_BF *= Eigen::AngleAxisd(turn, Vector3d::UnitY()).toRotationMatrix();
    elbow.pronation_zero_sd = pose.sigma;
  }

  // The zero of flexion moves until the elbow does not overstretch.
  void KeepFromOverstretching(const BallJoint& joint, Elbow& elbow) {
    const double beyond = kStretched - Ranges(joint, elbow).front().value * kDegree;
    if (beyond <= 0.0) return;
    elbow.R_AU *= Eigen::AngleAxisd(-beyond, Vector3d::UnitZ()).toRotationMatrix();
    result_.notes.push_back("upper_arm: the zero of flexion was moved by " + Degrees(beyond) +
                            " so that the elbow stretches to " + Degrees(kStretched) +
                            ", not further");
  }

  // From the 1 % to the 99 % quantile of every angle.
  std::vector<Figure> Ranges(const BallJoint& joint, const Elbow& elbow) const {
    std::vector<double> flexion, carrying, pronation;
    for (const Matrix3d& R_AB : joint.R_AB) {
      const ElbowAngles angles = AnglesAt(elbow, R_AB, side());
      flexion.push_back(angles.flexion / kDegree);
      carrying.push_back(angles.carrying / kDegree);
      pronation.push_back(angles.pronation / kDegree);
    }
    return {{"flexion_least_deg", Quantile(flexion, 0.01)},
            {"flexion_most_deg", Quantile(flexion, 0.99)},
            {"pronation_least_deg", Quantile(pronation, 0.01)},
            {"pronation_most_deg", Quantile(pronation, 0.99)},
            {"carrying_median_deg", Quantile(carrying, 0.5)},
            {"carrying_least_deg", Quantile(carrying, 0.01)},
            {"carrying_most_deg", Quantile(carrying, 0.99)}};
  }

  // Whether the movement shows the axes; if not, what movement would.
  bool IsTold(const BallJoint& joint, const HingeAxes& axes, const std::vector<Figure>& ranges) {
    const double flexion = (ranges[1].value - ranges[0].value) * kDegree;
    const double pronation = (ranges[3].value - ranges[2].value) * kDegree;
    if (flexion < kLeastRange || axes.j1_sd > kLeastKnownAxis)
      Refuse("the elbow bends by " + Degrees(flexion) + " and its axis is known to " +
             Degrees(axes.j1_sd) +
             ": bend and stretch it by 60 deg or more, the arm in several "
             "attitudes");
    if (pronation < kLeastRange || axes.j2_sd > kLeastKnownAxis)
      Refuse("the forearm turns by " + Degrees(pronation) + " and its axis is known to " +
             Degrees(axes.j2_sd) + ": turn the palm up and down, with the elbow bent and straight");
    if (joint.heading_sd > kLeastKnownHeading)
      Refuse("the heading of the forearm against the upper arm is known to " +
             Degrees(joint.heading_sd) + " only: move the elbow about the room, more briskly");
    return result_.faults.empty();
  }

  void Keep(const Recording& recording, const BallJoint& joint, const HingeAxes& axes,
            const Elbow& elbow) {
    const bool upper = recording.segment == Segment::kUpperArm;
    const Matrix3d R_BS = (upper ? elbow.R_AU : elbow.R_BF).transpose();
    const double axis = std::hypot(upper ? axes.j1_sd : axes.j2_sd, joint.heading_sd, floor_);
    const double zero = upper ? elbow.flexion_zero_sd : elbow.pronation_zero_sd;
    SegmentCalibration found{.segment = recording.segment, .mounting = {}, .figures = {}};
    if (recording.mounting) found.mounting = *recording.mounting;
    found.mounting.q_BS = Quaterniond(R_BS);
    found.mounting.q_sigma = std::max(axis, zero);
    if (!recording.mounting) {
      found.mounting.p_BS_B = R_BS * (upper ? joint.elbow_to_sensor_A : joint.elbow_to_sensor_B);
      if (upper)
        found.mounting.p_BS_B += observations_.arm.segments.at(recording.segment).p_distal_B;
      found.mounting.p_sigma = std::hypot(kPlaceSigma, joint.fore_sd);
    }
    const double zero_about_y = upper ? axis : zero, zero_about_z = upper ? zero : axis;
    found.figures = {{"rx_sd_deg", axis / kDegree},
                     {"ry_sd_deg", zero_about_y / kDegree},
                     {"rz_sd_deg", zero_about_z / kDegree}};
    if (upper) {
      const Vector3d line_A = -joint.shoulder_to_elbow_A;
      found.figures.push_back(
          {"z_from_line_to_shoulder_deg", AngleBetween(line_A, elbow.R_AU.col(2)) / kDegree});
    } else {
      found.figures.push_back(
          {"y_from_line_to_elbow_deg",
           AngleBetween(-joint.elbow_to_sensor_B, elbow.R_BF.col(1)) / kDegree});
      found.figures.push_back({"adduction_rms_deg", axes.misfit / kDegree});
      found.figures.push_back({"adduction_rms_of_next_axes_deg", axes.next_misfit / kDegree});
      found.figures.push_back({"relative_heading_sd_deg", joint.heading_sd / kDegree});
    }
    result_.segments.push_back(found);
  }

  void TellLimits(const StartPose& pose) {
    const std::string known = assumed_ ? "an arm that hangs with its thumb forward when the "
                                         "recordings begin, which is assumed"
                                       : "the told start pose";
    result_.notes.push_back(
        "forearm: no movement of the elbow shows the zero of pronation (the rotation of the sensor "
        "about the forearm); it comes from " +
        known + ", to " + Degrees(pose.sigma));
    result_.notes.push_back(
        "upper_arm: no movement of the elbow shows the zero of flexion (the rotation of the sensor "
        "about the flexion axis); it comes from the line between elbow and shoulder, as "
        "acceleration shows it, and " +
        known);
  }

  void Refuse(const std::string& why) { result_.faults.push_back(why); }
  Side side() const { return observations_.arm.side; }

  const Observations& observations_;
  double floor_;
  bool assumed_ = false;
  Calibration result_;
};

}  // namespace

Calibration SelfCalibrate(const Observations& observations, const CalibrationOptions& options) {
  return SelfCalibration(observations, options).Run();
}

}  // namespace brachium
