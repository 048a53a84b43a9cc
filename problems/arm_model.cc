#include "problems/arm_model.h"

namespace brachium {

// Mean adult lengths after Winter, Biomechanics and Motor Control of Human Movement, at 1.72 m of
// stature. The girdle runs from C7 to the glenohumeral centre: lateral, a little down and forward.
SegmentGeometry DefaultGeometry(Segment segment, Side side) {
  constexpr double kSigma = 0.02;
  switch (segment) {
    case Segment::kThorax:
      return {{0.0, 0.0, 0.17 * Sign(side)}, 0.04};
    case Segment::kGirdle:
      return {{0.03, -0.06, 0.17 * Sign(side)}, 0.04};
    case Segment::kUpperArm:
      return {{0.0, -0.30, 0.0}, kSigma};
    case Segment::kForearm:
      return {{0.0, -0.25, 0.0}, kSigma};
    case Segment::kHand:
      return {{0.0, -0.19, 0.0}, kSigma};
  }
  return {};
}

}  // namespace brachium
