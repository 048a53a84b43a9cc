// What the later samples say about the earlier ones: the fixed-interval smoother of Rauch, Tung &
// Striebel on the error state of a filter that ran forwards.
//
//   x_k = x_k⁺ [+] G (x_k+1 [-] x_k+1⁻),   P_k = P_k⁺ + G (P_k+1 - P_k+1⁻) Gᵀ,
//   G = P_k⁺ Fᵀ (P_k+1⁻)⁻¹
//
// with x⁻, P⁻ and F predicted once more from x⁺. [+], [-]: FilterState. The predicted accelerations
// are no part of the state: they stay as the filter had them.
// Source    Rauch, Tung & Striebel, AIAA Journal 3 (1965) 1445-1450.
#pragma once

#include <vector>

#include "solver/baselines/inclination_filter.h"

namespace brachium {

// In place: filtered states at successive instants become smoothed ones.
template <int kSegments>
void SmoothBackwards(const typename InclinationFilter<kSegments>::Members& members,
                     std::vector<FilterState<kSegments>>& states) {
  using State = FilterState<kSegments>;
  for (std::size_t k = states.size() - 1; k-- > 0;) {
    State& state = states[k];
    const State& next = states[k + 1];
    State predicted = state;
    const ErrorTransition<kSegments> F =
        InclinationFilter<kSegments>::Predict(members, next.time, predicted);
    const typename State::Matrix FP = F.TransposedAfter(state.P).transpose();
    const typename State::Matrix G = predicted.P.llt().solve(FP).transpose();
    state.Add(G * next.Minus(predicted));
    state.P += G * (next.P - predicted.P) * G.transpose();
  }
}

}  // namespace brachium
