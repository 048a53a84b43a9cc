#include "io/report/packed.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "io/report/html.h"

namespace brachium {
namespace {

constexpr double kGreatest = 32767.0;
constexpr double kTimeStep = 1e-5;  // [s]
constexpr double kMostTimes = 2147483647.0;

template <typename Unsigned>
void AppendBytes(Unsigned value, std::string* bytes) {
  for (std::size_t i = 0; i < sizeof value; ++i)
    bytes->push_back(static_cast<char>(static_cast<unsigned char>(value >> (8 * i) & 0xff)));
}

std::int16_t Whole(double parts) {
  if (!std::isfinite(parts)) return std::numeric_limits<std::int16_t>::min();
  return static_cast<std::int16_t>(std::lround(std::clamp(parts, -kGreatest, kGreatest)));
}

}  // namespace

nlohmann::ordered_json Packed(const std::vector<double>& values, double finest) {
  double low = 0.0, high = 0.0;
  bool any = false;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    low = any ? std::min(low, value) : value;
    high = any ? std::max(high, value) : value;
    any = true;
  }
  const bool near_zero = std::max(std::abs(low), std::abs(high)) <= finest * kGreatest;
  const double offset = near_zero ? 0.0 : (low + high) / 2.0;
  const double unit = near_zero ? finest : std::max(finest, (high - low) / 2.0 / kGreatest);
  std::string bytes;
  for (const double value : values)
    AppendBytes(static_cast<std::uint16_t>(Whole((value - offset) / unit)), &bytes);
  return {{"unit", unit}, {"offset", offset}, {"data", Base64(bytes)}};
}

std::string PackedExactly(const std::vector<double>& values) {
  std::string bytes;
  for (const double value : values) AppendBytes(std::bit_cast<std::uint64_t>(value), &bytes);
  return Base64(bytes);
}

nlohmann::ordered_json PackedTimes(const std::vector<double>& time) {
  if (time.empty()) return {{"unit", kTimeStep}, {"offset", 0.0}, {"data", ""}};
  const double unit = std::max(kTimeStep, (time.back() - time.front()) / kMostTimes);
  std::string bytes;
  for (const double t : time)
    AppendBytes(static_cast<std::uint32_t>(std::lround((t - time.front()) / unit)), &bytes);
  return {{"unit", unit}, {"offset", time.front()}, {"data", Base64(bytes)}};
}

}  // namespace brachium
