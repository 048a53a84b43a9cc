#include "solver/self_calibrate.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <string>

#include "problems/model_options.h"
#include "problems/statistics.h"
#include "solver/ball_joint.h"
#include "solver/calibration_movement.h"
#include "solver/elbow_zeros.h"
#include "solver/hinge_axes.h"

namespace brachium {
namespace {

using Eigen::Matrix3d, Eigen::Quaterniond, Eigen::Vector3d;

constexpr double kShortest = 10.0;            // [s]
constexpr double kLeastRange = 30 * kDegree;  // of flexion and of pronation
constexpr double kMostFlexion = 180 * kDegree, kMostPronation = 200 * kDegree;  // ranges
constexpr double kLeastKnownAxis = 12 * kDegree;                                // sd
constexpr double kLeastKnownHeading = 15 * kDegree;                             // sd
// A sensor on the skin lies up to 5 cm off the forearm's axis, 15 cm from the elbow.
constexpr double kSeatSigma = 20 * kDegree;
constexpr double kNearest = 0.05, kFarthest = 0.35;  // from the elbow to the forearm's sensor [m]
constexpr double kPlaceSigma = 0.01;                 // of a sensor, skin giving way [m]

std::string Centimetres(double length) { return std::to_string(std::lround(100 * length)) + " cm"; }

// Rotation by φ about an axis square to `direction` moves that by φ times the third.
double SdAbout(const Vector3d& axis, const Vector3d& direction, const Matrix3d& covariance) {
  const Vector3d moved = axis.cross(direction);
  return std::sqrt(moved.dot(covariance * moved));
}

// From the 1 % to the 99 % quantile [rad].
struct Range {
  double least, median, most;
};

Range RangeOf(const std::vector<double>& angles) {
  return {Quantile(angles, 0.01), Quantile(angles, 0.5), Quantile(angles, 0.99)};
}

struct Ranges {
  Range flexion, pronation, carrying;
};

Ranges RangesOf(const BallJoint& joint, const ElbowFrames& frames, Side side) {
  std::vector<double> flexion, pronation, carrying;
  for (const Matrix3d& R_AB : joint.R_AB) {
    const ElbowAngles angles = frames.AnglesAt(R_AB, side);
    flexion.push_back(angles.flexion);
    pronation.push_back(angles.pronation);
    carrying.push_back(angles.carrying);
  }
  return {RangeOf(flexion), RangeOf(pronation), RangeOf(carrying)};
}

std::vector<Figure> FiguresOf(const Ranges& ranges) {
  return {{"flexion_least_deg", ranges.flexion.least / kDegree},
          {"flexion_most_deg", ranges.flexion.most / kDegree},
          {"pronation_least_deg", ranges.pronation.least / kDegree},
          {"pronation_most_deg", ranges.pronation.most / kDegree},
          {"carrying_median_deg", ranges.carrying.median / kDegree},
          {"carrying_least_deg", ranges.carrying.least / kDegree},
          {"carrying_most_deg", ranges.carrying.most / kDegree}};
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
    const auto joint = FollowBallJoint(observations_, &why);
    if (!joint) return Refuse(why);
    if (joint->time.empty() || joint->time.back() - joint->time.front() < kShortest)
      return Refuse("both sensors together cover less than 10 s: record 10 s or more of movement");
    if (!IsPlaced(*joint)) return;
    const HingeAnatomy anatomy = AnatomyFrom(*joint);
    const HingeAxes axes = FindHingeAxes(joint->R_AB, anatomy);
    const ElbowFrames frames = FramesFrom(axes.j1_A, axes.j2_B, anatomy.to_shoulder_A);
    if (!IsTold(*joint, axes, RangesOf(*joint, frames, side()))) return;
    const auto pose = PoseForZeros(observations_, *joint, frames);
    if (!pose)
      return Refuse(
          "nothing tells the zero of pronation, which no movement shows: tell a start_pose "
          "(arms_along_body_thumbs_forward), or begin with a hanging arm, thumb forward");
    const ElbowZeros zeros = SetZeros(*joint, frames, anatomy.to_shoulder_sd, *pose, side());
    Keep(upper_arm, UpperArm(*joint, axes, zeros));
    Keep(forearm, Forearm(*joint, axes, zeros));
    TellLimits(*pose, zeros);
    TellDeparture(axes);
  }

  // Whether the elbow is seen where it can be. Shaken more by skin and straps than moved by the arm,
  // sensors seem to turn about themselves.
  bool IsPlaced(const BallJoint& joint) {
    const double apart = joint.elbow_to_sensor_B.norm();
    if (apart >= kNearest && apart <= kFarthest) return true;
    Refuse("the elbow is seen " + Centimetres(apart) + " from the forearm's sensor, where " +
           Centimetres(kNearest) + " to " + Centimetres(kFarthest) +
           " can be: bend and stretch it and turn the palm up and down, about the room and more "
           "briskly, with sensors that sit tight");
    return false;
  }

  // What the places of the joints and the usual elbow say of the axes. At worst all that the shoulder
  // strays goes along with the arm, and turns the line to it.
  HingeAnatomy AnatomyFrom(const BallJoint& joint) const {
    const double length = observations_.arm.segments.at(Segment::kUpperArm).p_distal_B.norm();
    return {.side = side(),
            .to_shoulder_A = -joint.shoulder_to_elbow_A.normalized(),
            .to_shoulder_sd = std::hypot(joint.upper_sd / joint.shoulder_to_elbow_A.norm(),
                                         observations_.arm.shoulder.sigma / length),
            .to_elbow_B = -joint.elbow_to_sensor_B.normalized(),
            .to_elbow_sd = std::hypot(joint.fore_sd / joint.elbow_to_sensor_B.norm(), kSeatSigma),
            .elbow = observations_.arm.elbow};
  }

  // Whether the movement shows the axes; if not, what movement would.
  bool IsTold(const BallJoint& joint, const HingeAxes& axes, const Ranges& ranges) {
    const double flexion = ranges.flexion.most - ranges.flexion.least;
    const double pronation = ranges.pronation.most - ranges.pronation.least;
    const double j1_sd = LargestSd(axes.j1_covariance), j2_sd = LargestSd(axes.j2_covariance);
    if (flexion < kLeastRange || j1_sd > kLeastKnownAxis)
      Refuse("the elbow bends by " + Degrees(flexion) + " and its axis is known to " +
             Degrees(j1_sd) +
             ": bend and stretch it by 60 deg or more, the arm in several attitudes");
    if (pronation < kLeastRange || j2_sd > kLeastKnownAxis)
      Refuse("the forearm turns by " + Degrees(pronation) + " and its axis is known to " +
             Degrees(j2_sd) + ": turn the palm up and down, with the elbow bent and straight");
    if (flexion > kMostFlexion || pronation > kMostPronation)
      Refuse("the elbow would bend by " + Degrees(flexion) + " and the forearm turn by " +
             Degrees(pronation) + ", which none does: the sensors cannot be followed");
    if (joint.heading_sd > kLeastKnownHeading)
      Refuse("the heading of the forearm against the upper arm is known to " +
             Degrees(joint.heading_sd) + " only: move the elbow about the room, more briskly");
    return result_.faults.empty();
  }

  static double LargestSd(const Matrix3d& covariance) {
    return std::sqrt(Eigen::SelfAdjointEigenSolver<Matrix3d>(covariance).eigenvalues()[2]);
  }

  struct Found {
    Matrix3d R_BS;
    Vector3d sds;  // about the segment's axes [rad]
    Vector3d p_BS_B;
    double p_sd;
    std::vector<Figure> figures;
  };

  Found UpperArm(const BallJoint& joint, const HingeAxes& axes, const ElbowZeros& zeros) const {
    const Matrix3d& R_AU = zeros.frames.R_AU;
    const auto sd = [&](int axis) {
      return AxisSd(joint, SdAbout(R_AU.col(axis), axes.j1_A, axes.j1_covariance));
    };
    const Vector3d line_A = -joint.shoulder_to_elbow_A;
    return {
        .R_BS = R_AU.transpose(),
        .sds = {sd(0), sd(1), zeros.flexion_sd},
        .p_BS_B = observations_.arm.segments.at(Segment::kUpperArm).p_distal_B +
                  R_AU.transpose() * joint.elbow_to_sensor_A,
        .p_sd = joint.fore_sd,
        .figures = {{"z_from_line_to_shoulder_deg", AngleBetween(line_A, R_AU.col(2)) / kDegree}}};
  }

  Found Forearm(const BallJoint& joint, const HingeAxes& axes, const ElbowZeros& zeros) const {
    const Matrix3d& R_BF = zeros.frames.R_BF;
    const auto sd = [&](int axis) {
      return AxisSd(joint, SdAbout(R_BF.col(axis), axes.j2_B, axes.j2_covariance));
    };
    std::vector<Figure> figures = {
        {"y_from_line_to_elbow_deg", AngleBetween(-joint.elbow_to_sensor_B, R_BF.col(1)) / kDegree},
        {"adduction_rms_deg", axes.misfit / kDegree},
        {"relative_heading_sd_deg", joint.heading_sd / kDegree}};
    for (const Figure& figure : FiguresOf(RangesOf(joint, zeros.frames, side())))
      figures.push_back(figure);
    return {.R_BS = R_BF.transpose(),
            .sds = {sd(0), zeros.pronation_sd, sd(2)},
            .p_BS_B = R_BF.transpose() * joint.elbow_to_sensor_B,
            .p_sd = joint.fore_sd,
            .figures = figures};
  }

  double AxisSd(const BallJoint& joint, double of_axis) const {
    return Eigen::Vector3d(of_axis, joint.heading_sd, floor_).norm();
  }

  void Keep(const Recording& recording, const Found& found) {
    Mounting mounting = recording.mounting.value_or(
        Mounting{.p_BS_B = found.p_BS_B, .p_sigma = std::hypot(kPlaceSigma, found.p_sd)});
    mounting.q_BS = Quaterniond(found.R_BS);
    mounting.q_sigma = found.sds.maxCoeff();
    std::vector<Figure> figures = {{"rx_sd_deg", found.sds.x() / kDegree},
                                   {"ry_sd_deg", found.sds.y() / kDegree},
                                   {"rz_sd_deg", found.sds.z() / kDegree}};
    figures.insert(figures.end(), found.figures.begin(), found.figures.end());
    result_.segments.push_back(
        {.segment = recording.segment, .mounting = mounting, .figures = figures});
  }

  void TellLimits(const HeldPose& pose, const ElbowZeros& zeros) {
    const std::string known = observations_.start_pose ? "the told start pose"
                                                       : "an arm that hangs with its thumb forward "
                                                         "when the recordings begin, which is "
                                                         "assumed";
    result_.notes.push_back(
        "forearm: no movement of the elbow shows the zero of pronation (the rotation of the sensor "
        "about the forearm); it comes from " +
        known + ", to " + Degrees(pose.sigma));
    result_.notes.push_back(
        "upper_arm: no movement of the elbow shows the zero of flexion (the rotation of the sensor "
        "about the flexion axis); it comes from the line between elbow and shoulder, as "
        "acceleration shows it, and " +
        known + ", to " + Degrees(zeros.flexion_sd));
    if (zeros.moved > 0.0)
      result_.notes.push_back("upper_arm: the zero of flexion was moved by " +
                              Degrees(zeros.moved) +
                              ", for the elbow would have overstretched by as much");
  }

  void TellDeparture(const HingeAxes& axes) {
    const ModelOptions model;
    const double allowed =
        std::hypot(model.elbow_adduction_sigma_deg, model.elbow_wobble_sigma_deg) * kDegree;
    if (axes.misfit > allowed)
      result_.notes.push_back(
          "the elbow departs from any two axes by " + Degrees(axes.misfit) +
          " rms: skin turns under the sensors, or one slipped; the carrying angle will not come "
          "out constant, and flexion and pronation are uncertain by as much at times");
  }

  void Refuse(const std::string& why) { result_.faults.push_back(why); }
  Side side() const { return observations_.arm.side; }

  const Observations& observations_;
  double floor_;
  Calibration result_;
};

}  // namespace

Calibration SelfCalibrate(const Observations& observations, const CalibrationOptions& options) {
  return SelfCalibration(observations, options).Run();
}

}  // namespace brachium
