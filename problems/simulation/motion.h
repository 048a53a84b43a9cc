// Smooth functions of time with exact first and second derivatives: what joints are moved by.
#pragma once

#include <vector>

#include "problems/simulation/draws.h"

namespace brachium {

// A scalar that moves: its value and its first and second time derivative, in unit, unit/s,
// unit/s^2.
struct Moving {
  double value = 0.0;
  double rate = 0.0;
  double acceleration = 0.0;
};

Moving operator+(const Moving& a, const Moving& b);
Moving operator-(const Moving& a);
Moving operator*(double k, const Moving& a);
Moving operator*(const Moving& a, const Moving& b);
Moving Cos(const Moving& angle);
Moving Sin(const Moving& angle);
Moving Asin(const Moving& x);                    // |x| < 1
Moving Atan2(const Moving& y, const Moving& x);  // not of (0, 0)
Moving Sqrt(const Moving& x);                    // x > 0
Moving Inverse(const Moving& x);                 // x != 0

// The step from 0 (u <= 0) to 1 (u >= 1), all derivatives continuous:
//   S(u) = 1 / (1 + exp(1/u - 1/(1 - u))).
// Bell-shaped speed with its peak, 2, in the middle (a minimum-jerk movement: 1.875).
Moving SmoothStep(double u);

// The minimum-jerk step, 10 u^3 - 15 u^4 + 6 u^5 between 0 and 1: the speed profile of unhurried
// human reaching (Flash & Hogan, J. Neurosci. 5 (1985)). Its third derivative jumps at both ends.
Moving MinimumJerkStep(double u);

enum class StepShape { kSmooth, kMinimumJerk };

// A start value plus steps (movements, which may overlap) plus sinusoids.
class Motion {
 public:
  explicit Motion(double start = 0.0);

  // Adds `change` between `start` and `start + duration` [s], duration > 0. Steps are added in the
  // order of their starts.
  void AddStep(double start, double duration, double change, StepShape shape = StepShape::kSmooth);

  // Adds amplitude * sin(2 pi frequency t + phase); frequency in Hz, phase in rad.
  void AddSinusoid(double amplitude, double frequency, double phase);

  Moving At(double t) const;  // t in s

 private:
  struct Step {
    double start, duration, change;
    double before;  // the value when all earlier steps are done
    StepShape shape;
  };
  struct Sinusoid {
    double amplitude, angular_frequency, phase;
  };
  double end_;  // the value when all steps are done
  double longest_ = 0.0;
  std::vector<Step> steps_;
  std::vector<Sinusoid> sinusoids_;
};

// A coloured random process, nearly Gaussian, of the given rms: sinusoids of equal power and random
// phase spread evenly, on a logarithmic scale, over the two octaves about `frequency` [Hz].
Motion RandomMotion(double rms, double frequency, Draws& draws);

}  // namespace brachium
