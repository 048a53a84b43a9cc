// A trial: what was observed and, where there is one, an independent reference to judge by.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "problems/observations.h"

namespace brachium {

// An independent truth, optical or simulated, in its own world V (z up, heading free). A quaternion
// or a coordinate that is NaN is a gap. Positions are by name: "shoulder", "elbow", "wrist",
// "hand", or a segment's name for the position of its only sensor; a reference without height has
// NaN in z.
struct Reference {
  enum class Frames {
    kSegment,  // the frames are the segments' own
    kCluster,  // rigid to the segments, but turned by an unknown constant
  };
  std::vector<double> time;  // [s], on the reference's clock
  std::map<Segment, std::vector<Eigen::Quaterniond>> q_VB;
  std::map<std::string, std::vector<Eigen::Vector3d>> p_V;  // [m]
  Frames frames = Frames::kSegment;
  std::optional<double> clock_offset;  // reference time = recording time + offset [s]
};

struct Trial {
  std::string name;
  Observations observations;
  std::optional<Reference> reference;
};

}  // namespace brachium
