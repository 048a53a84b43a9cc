// How far an estimate is from an independent reference. Errors are estimate minus reference, at the
// reference's own instants: the estimate is interpolated (never across a gap), the reference never.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "problems/alignment.h"
#include "problems/clock_offset.h"
#include "problems/estimate.h"
#include "problems/joint_angle_errors.h"
#include "problems/movement_outcomes.h"
#include "problems/orientation_errors.h"
#include "problems/position_errors.h"
#include "problems/statistics.h"
#include "problems/trial.h"

namespace brachium {

// One rotation with nothing removed and after `alignment`.
struct OrientationEvaluation {
  OrientationErrors raw;
  OrientationErrors aligned;
  RotationAlignment alignment;  // reference ≈ proximal * estimate * distal
};

// A segment in the next one above it: "forearm_in_upper_arm". For frames that are the segments' own
// raw is the figure to go by; otherwise it is aligned, with a constant removed on each side.
struct RelativeEvaluation {
  std::string name;
  OrientationEvaluation orientation;
  std::vector<double> angle;  // of the figure to go by, over Evaluation::time [rad]
};

// After the common heading and shift, least squares over all points and instants.
struct PositionEvaluation {
  PositionErrors raw;
  PositionErrors aligned;
  double path_length = 0.0;         // of the reference, picked every 0.1 s, gaps left out [m]
  double final_horizontal = 0.0;    // at the last instant compared, after the alignment [m]
  double closing_horizontal = 0.0;  // the same with the first instants laid together instead [m]
  std::vector<double> distance;     // after the alignment, over Evaluation::time [m]
};

struct Evaluation {
  std::string method;
  Reference::Frames frames = Reference::Frames::kSegment;
  ClockOffset clock_offset;
  std::size_t reference_samples = 0;  // instants of the reference
  std::vector<double> time;           // these, on the recordings' clock [s]; errors over it are NaN
                                      // where nothing could be compared
  std::size_t used = 0;               // those at which anything could be compared
  double heading = 0.0;  // reference's world from the estimate's, of orientations [rad]
  std::map<Segment, OrientationEvaluation> orientation;  // after heading, and for kCluster frames
                                                         // one constant rotation of each body
  std::vector<RelativeEvaluation> relative;
  std::map<std::string, JointAngleError> joint_angles;  // "elbow_flexion", ...; kSegment only
  PointAlignment point_alignment;
  std::map<std::string, PositionEvaluation> positions;
  MovementOutcomes outcomes;            // by the estimate
  MovementOutcomes reference_outcomes;  // by the reference, of what both of them hold
};

// Compares whatever both of them hold; without any common sample, `used` is 0 and statistics are
// unknown.
Evaluation Evaluate(const Estimate& estimate, const Reference& reference);

}  // namespace brachium
