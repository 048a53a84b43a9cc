#include "problems/simulation/motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brachium {

Moving operator+(const Moving& a, const Moving& b) {
  return {a.value + b.value, a.rate + b.rate, a.acceleration + b.acceleration};
}

Moving operator-(const Moving& a) { return {-a.value, -a.rate, -a.acceleration}; }

Moving operator*(double k, const Moving& a) {
  return {k * a.value, k * a.rate, k * a.acceleration};
}

Moving operator*(const Moving& a, const Moving& b) {
  return {a.value * b.value, a.rate * b.value + a.value * b.rate,
          a.acceleration * b.value + 2.0 * a.rate * b.rate + a.value * b.acceleration};
}

Moving Cos(const Moving& angle) {
  const double c = std::cos(angle.value), s = std::sin(angle.value);
  return {c, -s * angle.rate, -c * angle.rate * angle.rate - s * angle.acceleration};
}

Moving SmoothStep(double u) {
  constexpr double kFlat = 1e-2;  // exp(-1 / kFlat) is far below the rounding of 1
  if (u <= kFlat) return {};
  const double v = 1.0 - u;
  if (v <= kFlat) return {1.0, 0.0, 0.0};
  const double dw = -1.0 / (u * u) - 1.0 / (v * v);
  const double ddw = 2.0 / (u * u * u) - 2.0 / (v * v * v);
  const double s = 1.0 / (1.0 + std::exp(1.0 / u - 1.0 / v));
  const double slope = s * (1.0 - s);
  const double rate = -dw * slope;
  return {s, rate, -ddw * slope - dw * (1.0 - 2.0 * s) * rate};
}

Motion::Motion(double start) : end_(start) {}

void Motion::AddStep(double start, double duration, double change) {
  steps_.push_back({start, duration, change, end_});
  end_ += change;
  longest_ = std::max(longest_, duration);
}

void Motion::AddSinusoid(double amplitude, double frequency, double phase) {
  sinusoids_.push_back({amplitude, 2.0 * std::numbers::pi * frequency, phase});
}

Moving Motion::At(double t) const {
  Moving sum{end_, 0.0, 0.0};
  auto step = std::upper_bound(steps_.begin(), steps_.end(), t,
                               [](double time, const Step& s) { return time < s.start; });
  if (step != steps_.end()) sum.value = step->before;
  while (step != steps_.begin() && t - (step - 1)->start < longest_) {
    --step;
    const Moving unit = SmoothStep((t - step->start) / step->duration);
    sum = sum + Moving{step->change * (unit.value - 1.0), step->change * unit.rate / step->duration,
                       step->change * unit.acceleration / (step->duration * step->duration)};
  }
  for (const Sinusoid& s : sinusoids_) {
    const double w = s.angular_frequency;
    const double sine = s.amplitude * std::sin(w * t + s.phase);
    const double cosine = s.amplitude * std::cos(w * t + s.phase);
    sum = sum + Moving{sine, w * cosine, -w * w * sine};
  }
  return sum;
}

Motion RandomMotion(double rms, double frequency, Draws& draws) {
  constexpr int kCount = 12;
  Motion motion;
  for (int i = 0; i < kCount; ++i) {
    const double octave = -1.0 + 2.0 * (i + draws.Uniform(0.0, 1.0)) / kCount;
    const double phase = draws.Uniform(0.0, 2.0 * std::numbers::pi);
    motion.AddSinusoid(rms * std::sqrt(2.0 / kCount), frequency * std::exp2(octave), phase);
  }
  return motion;
}

}  // namespace brachium
