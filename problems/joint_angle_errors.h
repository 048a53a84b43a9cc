// Errors of the clinical joint angles.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "problems/agreement.h"
#include "problems/alignment.h"
#include "problems/segment.h"
#include "problems/statistics.h"

namespace brachium {

// [rad]
struct JointAngleError : Statistics {
  std::optional<double> concordance{};
  std::optional<LimitsOfAgreement> limits{};
  // Over the pairs; the estimate on the turn of the circle that is nearest to the reference.
  std::vector<double> estimate{}, reference{};
};

// By the names of JointAngleSeries(). The shortest way round the circle; an instant at which either
// has no such angle is left out. Needs the segments' own frames.
std::map<std::string, JointAngleError> JointAngleErrors(
    const std::map<Segment, RotationPairs>& segments, Side side);

}  // namespace brachium
