// How a patient moves, over ten weekly sessions of rehabilitation.
//
// Source: Bai et al., IEEE TNSRE 23 (2015), section III: shoulder abduction from 60 deg to 120 deg
// along an S, with a setback in weeks 5 and 6; twice a healthy person's time at the end; the trunk
// and the shoulder help by 5-10 cm. The values between, the tremor and the strokes are ours.
#pragma once

#include <array>

#include "problems/arm_model.h"

namespace brachium {

inline constexpr int kPatientWeeks = 10;

// How far the arm can be abducted [rad]; week from 1.
inline double PatientAbduction(int week) {
  constexpr std::array<double, kPatientWeeks> kReached = {60, 63,  71,  85,  79,
                                                          76, 104, 116, 119, 120};
  return kReached.at(static_cast<std::size_t>(week - 1)) * kDegree;
}

// 1 in the worst, 0 in the best week.
inline double Severity(int week) {
  return (120 * kDegree - PatientAbduction(week)) / (60 * kDegree);
}

// How many times slower than a healthy person; 1 for one (week 0).
inline double Slowness(int week) { return week == 0 ? 1.0 : 2.0 + Severity(week); }

// In how many strokes a patient makes a movement; a healthy person (week 0) in one.
inline int Strokes(int week) {
  return week == 0 ? 1 : 2 + static_cast<int>(2.0 * Severity(week) + 0.5);
}

// Tremor at 4-6 Hz, rms of each angle [rad]: some millimetres at the fingertip.
inline double PatientTremor(int week) {
  return week == 0 ? 0.0 : (0.1 + 0.2 * Severity(week)) * kDegree;
}

}  // namespace brachium
