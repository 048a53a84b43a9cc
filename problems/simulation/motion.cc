#include "problems/simulation/motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brachium {
namespace {

// f(x) from the value and the first two derivatives of f at x.
Moving Chain(double value, double slope, double curvature, const Moving& x) {
  return {value, slope * x.rate, slope * x.acceleration + curvature * x.rate * x.rate};
}

Moving StepAt(StepShape shape, double u) {
  return shape == StepShape::kSmooth ? SmoothStep(u) : MinimumJerkStep(u);
}

}  // namespace

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

Moving Sin(const Moving& angle) {
  const double s = std::sin(angle.value);
  return Chain(s, std::cos(angle.value), -s, angle);
}

Moving Asin(const Moving& x) {
  const double slope = 1.0 / std::sqrt(1.0 - x.value * x.value);
  return Chain(std::asin(x.value), slope, x.value * slope * slope * slope, x);
}

// The angle turns at n / r^2 with n = x y' - y x' and r^2 = x^2 + y^2.
Moving Atan2(const Moving& y, const Moving& x) {
  const double r2 = x.value * x.value + y.value * y.value;
  const double rate = (x.value * y.rate - y.value * x.rate) / r2;
  const double turned = x.value * y.acceleration - y.value * x.acceleration;
  const double stretched = 2.0 * (x.value * x.rate + y.value * y.rate);
  return {std::atan2(y.value, x.value), rate, (turned - stretched * rate) / r2};
}

Moving Sqrt(const Moving& x) {
  const double root = std::sqrt(x.value);
  return Chain(root, 0.5 / root, -0.25 / (root * x.value), x);
}

Moving Inverse(const Moving& x) {
  const double inverse = 1.0 / x.value;
  return Chain(inverse, -inverse * inverse, 2.0 * inverse * inverse * inverse, x);
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

Moving MinimumJerkStep(double u) {
  if (u <= 0.0) return {};
  if (u >= 1.0) return {1.0, 0.0, 0.0};
  const double v = 1.0 - u;
  return {u * u * u * (10.0 + u * (-15.0 + 6.0 * u)), 30.0 * u * u * v * v, 60.0 * u * v * (v - u)};
}

Motion::Motion(double start) : end_(start) {}

void Motion::AddStep(double start, double duration, double change, StepShape shape) {
  steps_.push_back({start, duration, change, end_, shape});
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
    const Moving unit = StepAt(step->shape, (t - step->start) / step->duration);
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
