#include "problems/segment.h"

namespace brachium {

std::string_view Name(Segment segment) {
  switch (segment) {
    case Segment::kThorax:
      return "thorax";
    case Segment::kGirdle:
      return "girdle";
    case Segment::kUpperArm:
      return "upper_arm";
    case Segment::kForearm:
      return "forearm";
    case Segment::kHand:
      return "hand";
  }
  return "";
}

std::string_view Name(Side side) { return side == Side::kRight ? "right" : "left"; }

std::optional<Segment> SegmentFromName(std::string_view name) {
  for (const Segment segment : kSegments)
    if (Name(segment) == name) return segment;
  return std::nullopt;
}

std::string_view DistalJointName(Segment segment) {
  switch (segment) {
    case Segment::kThorax:
    case Segment::kGirdle:
      return "shoulder";
    case Segment::kUpperArm:
      return "elbow";
    case Segment::kForearm:
      return "wrist";
    case Segment::kHand:
      return "hand";
  }
  return "";
}

std::string_view ProximalJointName(Segment segment) {
  switch (segment) {
    case Segment::kUpperArm:
      return "shoulder";
    case Segment::kForearm:
      return "elbow";
    case Segment::kHand:
      return "wrist";
    default:
      return "";
  }
}

}  // namespace brachium
