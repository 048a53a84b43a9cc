#include "problems/simulation/draws.h"

#include <cmath>
#include <numbers>

namespace brachium {
namespace {

// FNV-1a over the name, started from the seed.
std::uint64_t StreamSeed(std::uint64_t seed, std::string_view stream) {
  std::uint64_t hash = 0xcbf29ce484222325ULL ^ (seed * 0x9e3779b97f4a7c15ULL);
  for (const char c : stream) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3ULL;
  }
  return hash;
}

}  // namespace

Draws::Draws(std::uint64_t seed, std::string_view stream) : generator_(StreamSeed(seed, stream)) {}

double Draws::Uniform(double low, double high) {
  const double unit = static_cast<double>(generator_() >> 11) * 0x1p-53;
  return low + (high - low) * unit;
}

// Box-Muller; the second of each pair is not kept, so that a stream has no hidden state.
double Draws::Normal() {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - Uniform(0.0, 1.0)));
  return radius * std::cos(2.0 * std::numbers::pi * Uniform(0.0, 1.0));
}

double Draws::Sign() { return Uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0; }

Eigen::Vector3d Draws::Normal3() {
  const double x = Normal(), y = Normal(), z = Normal();
  return {x, y, z};
}

Eigen::Vector3d Draws::OfLength(double length) { return length * Normal3().normalized(); }

Eigen::Vector3d Draws::OfRms(double rms) { return OfLength(rms * std::numbers::sqrt3); }

}  // namespace brachium
