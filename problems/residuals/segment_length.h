// Segment length: a joint lies where it was measured to lie, within the error of the tape.
//
//   r = (d - d_measured) / σ
//
// Frames    d: from a segment's proximal to its distal joint, in its axes [m]; (0, -L, 0) for an
//           anatomical segment of length L.
// Unknowns  d. Weight σ [m], a tape 5 mm. Jacobian I/σ.
// Blind to  everything else: the accelerometers of the sensors beyond the joint inform d wherever
//           the segment turns (accelerometer.h); the length and the place of the segment's own sensor
//           along it are seen as a difference only.
// Source    known lengths as constraints: Zhou et al., Med. Eng. Phys. 30 (2008), eqs. 6 and 7.
#pragma once

#include "problems/residuals/prior.h"

namespace brachium {

class SegmentLength : public Prior<3> {
 public:
  SegmentLength(const Eigen::Vector3d& measured, double sigma)
      : Prior(measured, Eigen::Vector3d::Constant(sigma)) {}
};

}  // namespace brachium
