// The smoother for trials of any length: windows alone, stretch after stretch, in memory that does
// not grow with the trial.
//
// A stretch is an objective of its own over about a minute. It reaches a window beyond the knot, a
// bias node, at which the next one begins; what its terms before that knot say goes on as a marginal
// prior, so that the windows run through as if the trial were one. Every sample leaves when its
// stretch is done, with the standard deviations that its last window knew: what came later is not in
// them. Clocks are constants of a stretch; from one to the next they go on at the rate at which they
// went so far, and by a random step.
#pragma once

#include <functional>

#include "problems/sample_source.h"
#include "solver/batch_smoother.h"

namespace brachium {

// Receives the motion piece by piece, in the order of time, every sample of the first recording
// once: an estimate without diagnostics.
using EstimateSink = std::function<void(const Estimate& piece)>;

// Sensors' crystals may be off by so much from one another: over a stretch the clocks go astray by
// this share of its length, standard deviation.
inline constexpr double kClockDrift = 20e-6;

// Requires observations that the smoother accepts. Returns what is told at the end, without motion:
// constants as they stand at the end, sums over the trial of residuals, rests.
Estimate SmoothInStretches(StreamedObservations& trial, const SmootherOptions& options,
                           const EstimateSink& sink, const Progress& progress);

}  // namespace brachium
