// What a movement says of the person who made it: when they moved, how fast, how smoothly, how
// directly, how far each joint went, and what trunk and shoulder added.
// After Bai et al., IEEE TNSRE 23 (2015), sections II.D and III; Rohrer et al., J. Neurosci. 22 (2002).
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "problems/segment.h"

namespace brachium {

// Of one movement between two rests. Speeds are those of a point [m/s] or, where no position is
// known, of a segment's turning [rad/s]; ways along them in m or rad.
struct MovementEpoch {
  double start = 0.0, end = 0.0;  // [s]
  double peak_speed = 0.0;
  double time_to_peak = 0.0;  // from the start [s]
  int speed_peaks = 0;        // smoothness.h, like the two below
  double spectral_arc_length = 0.0;
  double log_jerk = 0.0;
  double path = 0.0;
  std::optional<double> path_ratio{};  // path over the straight way; none where that is under a
                                       // hundredth of it, and of turning
};

struct AngleRange {
  double least = 0.0, greatest = 0.0;  // [rad]
};

struct MovementOutcomes {
  std::string mover{};   // "hand", "wrist", "elbow", or the segment whose turning was looked at
  bool is_point = true;  // it is a point
  std::vector<MovementEpoch> epochs;
  std::map<std::string, AngleRange> ranges;  // by joint angle: the 1 % and 99 % quantiles
  std::optional<double> shoulder_range{};    // the greatest way from its median place [m]
  std::optional<double> trunk_tilt{};  // the greatest angle from its median direction up [rad]
};

// The most distal point known ("hand", "wrist", "elbow") decides when there is movement, or the most
// distal segment where none is known. It is made even over the median step, smoothed to 10 Hz by a
// Gaussian, never across a gap; a movement is faster than a twentieth of the 95 % quantile of the
// speed (and than 1 cm/s or 3 deg/s) for 0.2 s or more, and does not pause for 0.1 s.
MovementOutcomes OutcomesOf(Side side, const std::vector<double>& time,
                            const std::map<Segment, std::vector<Eigen::Quaterniond>>& q_WB,
                            const std::map<std::string, std::vector<Eigen::Vector3d>>& p_W);

}  // namespace brachium
