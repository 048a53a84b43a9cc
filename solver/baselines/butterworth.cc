#include "solver/baselines/butterworth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brachium {
namespace {

using Eigen::Vector3d;
using Signal = std::vector<Vector3d>;

// y = b0 x + b1 x⁻ + b2 x⁻⁻ - a1 y⁻ - a2 y⁻⁻.
struct Section {
  double b0, b1, b2, a1, a2;
};

// The prototype's factor s² + damping s + 1.
Section SecondOrder(double K, double damping, bool low) {
  const double norm = 1 / (1 + damping * K + K * K), b = low ? K * K * norm : norm;
  return {b, low ? 2 * b : -2 * b, b, 2 * (K * K - 1) * norm, (1 - damping * K + K * K) * norm};
}

// The prototype's factor s + 1.
Section FirstOrder(double K, bool low) {
  const double norm = 1 / (1 + K), b = low ? K * norm : norm;
  return {b, low ? b : -b, 0.0, (K - 1) * norm, 0.0};
}

std::vector<Section> SectionsOf(const Butterworth& filter, double period) {
  const double K = std::tan(std::numbers::pi * filter.cutoff * period);
  const bool low = filter.band == Butterworth::Band::kLow;
  std::vector<Section> sections;
  for (int k = 1; k <= filter.order / 2; ++k)
    sections.push_back(
        SecondOrder(K, 2 * std::sin(std::numbers::pi * (2 * k - 1) / (2 * filter.order)), low));
  if (filter.order % 2 == 1) sections.push_back(FirstOrder(K, low));
  return sections;
}

// Transposed direct form, from the steady state of the first sample.
void Apply(const Section& c, bool low, Signal& signal) {
  const Vector3d x0 = signal.front(), y0 = low ? x0 : Vector3d::Zero();
  Vector3d second = c.b2 * x0 - c.a2 * y0, first = c.b1 * x0 - c.a1 * y0 + second;
  for (Vector3d& sample : signal) {
    const Vector3d x = sample, y = c.b0 * x + first;
    first = c.b1 * x - c.a1 * y + second;
    second = c.b2 * x - c.a2 * y;
    sample = y;
  }
}

void ApplyAll(const std::vector<Section>& sections, bool low, Signal& signal) {
  for (const Section& section : sections) Apply(section, low, signal);
}

// The signal with its point reflections about its first and last sample, `reach` samples of each.
Signal Reflected(const Signal& signal, std::size_t reach) {
  Signal longer;
  longer.reserve(signal.size() + 2 * reach);
  for (std::size_t i = reach; i > 0; --i) longer.push_back(2 * signal.front() - signal[i]);
  longer.insert(longer.end(), signal.begin(), signal.end());
  for (std::size_t i = 1; i <= reach; ++i)
    longer.push_back(2 * signal.back() - signal[signal.size() - 1 - i]);
  return longer;
}

}  // namespace

Signal Filtered(const Signal& signal, double period, const Butterworth& filter) {
  const std::vector<Section> sections = SectionsOf(filter, period);
  const bool low = filter.band == Butterworth::Band::kLow;
  if (!filter.zero_phase) {
    Signal filtered = signal;
    ApplyAll(sections, low, filtered);
    return filtered;
  }
  const double memory = 2 * filter.order / (filter.cutoff * period);  // [samples]
  const std::size_t reach = std::min(signal.size() - 1, static_cast<std::size_t>(memory));
  Signal filtered = Reflected(signal, reach);
  for (int pass = 0; pass < 2; ++pass) {
    ApplyAll(sections, low, filtered);
    std::reverse(filtered.begin(), filtered.end());
  }
  const auto begin = filtered.begin() + static_cast<std::ptrdiff_t>(reach);
  return {begin, begin + static_cast<std::ptrdiff_t>(signal.size())};
}

}  // namespace brachium
