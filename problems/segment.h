// The rigid bodies of the arm, from proximal to distal, and the two sides of a person.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace brachium {

enum class Side { kRight, kLeft };

// +1 on the right, -1 on the left: the s of problems/README.md.
constexpr double Sign(Side side) { return side == Side::kRight ? 1.0 : -1.0; }

// Order is proximal to distal. The girdle reaches from C7 to the glenohumeral centre.
enum class Segment { kThorax, kGirdle, kUpperArm, kForearm, kHand };

inline constexpr std::array kSegments = {Segment::kThorax, Segment::kGirdle, Segment::kUpperArm,
                                         Segment::kForearm, Segment::kHand};

// The name used in files and messages: "thorax", "girdle", "upper_arm", "forearm", "hand".
std::string_view Name(Segment segment);
std::string_view Name(Side side);  // "right", "left"

// The segment of that name, or none.
std::optional<Segment> SegmentFromName(std::string_view name);

// The joint at a segment's distal end: "shoulder" for thorax and girdle, "elbow", "wrist", "hand".
std::string_view DistalJointName(Segment segment);

// At its proximal end, where that joint has a name: "shoulder", "elbow", "wrist", or "".
std::string_view ProximalJointName(Segment segment);

}  // namespace brachium
