// What holds the heading of one segment against that of the one before it.
//
// Everything beyond a joint is turned by a small ψ about the vertical through it, at all knots at
// once: attitudes, places about the joint, velocities about the joint's. What the whitened residuals
// of a kind change by is what that kind knows of the heading,
//   I_kind = Σ |∂r/∂ψ|²,   sd_kind = 1 / √I_kind.
// A turn changes neither gyroscopes nor chains; accelerometers feel it where the joint accelerates
// across the vertical, the elbow's adduction by n_z (Luinge et al. 2007), rests and poses as they do.
// The joint's velocity is the slope of its places over the neighbouring knots.
#pragma once

#include <vector>

#include "problems/arm_problem.h"
#include "problems/estimate.h"
#include "solver/pose_covariance.h"

namespace brachium {

// One for each sensor of the arm but the first.
std::vector<HeadingSupport> DescribeHeadings(const ArmProblem& problem, const State& state,
                                             const PoseCovariance& covariance);

// A sentence for each stretch in which a heading's standard deviation exceeds 10 deg.
std::vector<std::string> HeadingsNotHeld(const std::vector<HeadingSupport>& headings);

}  // namespace brachium
