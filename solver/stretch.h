// What one stretch of a long trial hands to the next at the knot where it ends: a marginal prior and
// the values of the unknowns that it speaks of, by what they are, since each stretch counts its
// unknowns anew.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "solver/front_plan.h"

namespace brachium {

struct Handover {
  // An unknown of the knot, of the bias node on it, or a constant.
  struct Known {
    Unknown unknown;
    std::string place;  // of a contact, whose number may change
    std::vector<double> value;
  };
  double time = 0.0;          // of the knot [s]
  double touches_from = 0.0;  // contacts after it belong to the knot or to later ones [s]
  std::vector<Known> known;
  std::unique_ptr<MarginalPrior> prior;  // about `known`

  // A number that is known by sensor, or zeros.
  std::vector<double> Of(UnknownKind kind, int sensor) const;
};

// `prior` about an inner `knot`, a bias node, and its neighbours in time; values from `state`.
Handover HandOver(const ArmProblem& problem, State& state, const CarriedPrior& prior, int knot);

// Clocks that are not the true time go on by `steps`, by sensor, and may go astray by this sd [s].
void LetClocksDrift(Handover& handover, const std::vector<double>& steps, double sigma);

// Sets the first knot, the biases and the constants of a stretch that begins where the handover was
// made; returns the prior about its unknowns.
CarriedPrior TakeOver(const Handover& handover, const ArmProblem& problem, State& state);

// What is told about the arm from a handover on (null: from the start) up to `end`, which is +inf
// for all the rest: poses and contacts. Recordings stay as they are.
Observations ToldBetween(Observations told, const Handover* from, double end);

}  // namespace brachium
