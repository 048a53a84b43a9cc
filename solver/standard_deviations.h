// What the covariance of the pose says about every sample of a trajectory.
#pragma once

#include "problems/estimate.h"
#include "solver/pose_covariance.h"

namespace brachium {

// Fills sd_B, sd_W and sd_angle of an estimate whose trajectory is filled. Of a joint angle f the
// variance is ∇fᵀ P ∇f, the gradient over small rotations of the distal segment against the proximal
// one; near a pole it is large, and absent where the angle is.
void FillStandardDeviations(const ArmProblem& problem, const PoseCovariance& covariance,
                            Estimate& estimate);

// Multiplies all of them, those of the constants and headings too.
void ScaleStandardDeviations(double factor, Estimate& estimate);

}  // namespace brachium
