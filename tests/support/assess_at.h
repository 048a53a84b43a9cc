// The certainty of a state that was not just solved for.
#pragma once

#include "solver/covariance.h"

namespace brachium {

inline Certainty AssessAt(const ArmProblem& problem, State& state,
                          PoseCovariance* poses = nullptr) {
  ChainWorkspace workspace(problem);
  workspace.Linearise(problem, state);
  return AssessCertainty(problem, state, workspace, poses);
}

}  // namespace brachium
