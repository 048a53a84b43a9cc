// Where joints and segments are at chosen instants, for drawing an arm.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "io/report/reported.h"

namespace brachium {

// In the estimate's world, an entry per frame; NaN where unknown.
struct Posture {
  std::map<std::string, std::vector<Eigen::Vector3d>> p_W;  // of joints [m]
  std::map<Segment, std::vector<Eigen::Quaterniond>> q_WB;
};

// A segment as drawn, between two joints; those of a lone sensor are the same.
struct Bone {
  std::string from, to;
  Segment segment;
};

struct Drawn {
  Posture posture;
  std::vector<Bone> bones;
  bool nominal = false;  // lengths are an adult's, for the picture: the estimate tells no positions
};

// The estimate at these samples. What stands between joints that it tells is drawn there, a lone
// sensor at its place, and other segments hang from the one before them.
Drawn DrawnEstimate(const Estimate& estimate, const std::vector<std::size_t>& samples);

// The reference at its instants nearest to those samples, its alignment with the estimate removed.
// Joints that it does not tell hang from the estimate's first joint, with the estimate's lengths.
// Requires an evaluation.
Posture DrawnReference(const ReportedEstimate& reported, const Drawn& drawn,
                       const std::vector<std::size_t>& samples);

}  // namespace brachium
