#include "io/plot/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace brachium {
namespace {

constexpr std::array kSeries = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                "#e69f00", "#56b4e9", "#f0e442", "#000000"};
constexpr std::array<const char*, 4> kDashes = {"", "6 3", "2 2", "8 3 2 3"};

using Rgb = std::array<double, 3>;
constexpr std::array<Rgb, 5> kScale = {
    {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};

}  // namespace

std::string SeriesColour(std::size_t i) { return kSeries[i % kSeries.size()]; }

std::string SeriesDashes(std::size_t i) { return kDashes[i / kSeries.size() % kDashes.size()]; }

std::string ScaleColour(double fraction) {
  const double place = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(kScale.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kScale.size() - 2);
  std::array<int, 3> colour{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double part = place - static_cast<double>(below);
    colour[i] = static_cast<int>(
        std::lround((1.0 - part) * kScale[below][i] + part * kScale[below + 1][i]));
  }
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", static_cast<unsigned>(colour[0]) & 255u,
                static_cast<unsigned>(colour[1]) & 255u, static_cast<unsigned>(colour[2]) & 255u);
  return text.data();
}

}  // namespace brachium
