#include "io/formats/export_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "io/input_error.h"
#include "io/text.h"
#include "problems/arm_model.h"

namespace brachium {
namespace {

constexpr double kStandardGravity = 9.80665;  // [m/s^2], what "g" means as a unit

struct Unit {
  Quantity quantity;
  std::string_view name;
  double factor;
};

constexpr Unit kUnits[] = {
    {Quantity::kAngularRate, "rad/s", 1.0},
    {Quantity::kAngularRate, "deg/s", kDegree},
    {Quantity::kAngularRate, "dps", kDegree},
    {Quantity::kAngularRate, "\xc2\xb0/s", kDegree},
    {Quantity::kAcceleration, "m/s^2", 1.0},
    {Quantity::kAcceleration, "m/s2", 1.0},
    {Quantity::kAcceleration, "m/s\xc2\xb2", 1.0},
    {Quantity::kAcceleration, "m/s/s", 1.0},
    {Quantity::kAcceleration, "g", kStandardGravity},
    {Quantity::kAcceleration, "mg", 1e-3 * kStandardGravity},
    {Quantity::kTime, "s", 1.0},
    {Quantity::kTime, "ms", 1e-3},
    {Quantity::kTime, "us", 1e-6},
    {Quantity::kTime, "\xc2\xb5s", 1e-6},
};

std::string_view WithoutBlanksBehind(std::string_view line) {
  const auto last = line.find_last_not_of(" \r");
  return last == line.npos ? std::string_view() : line.substr(0, last + 1);
}

double Wrapped(double difference, double modulus) {
  return difference - modulus * std::round(difference / modulus);
}

}  // namespace

std::string_view Lines::Next() {
  if (AtEnd()) return {};
  const std::size_t end = std::min(rest_.find('\n'), rest_.size());
  const std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  ++number_;
  return WithoutBlanksBehind(line);
}

char DelimiterOf(std::string_view line) {
  constexpr std::string_view kDelimiters = "\t,; ";
  return *std::ranges::max_element(kDelimiters, {},
                                   [line](char c) { return std::ranges::count(line, c); });
}

std::optional<std::string> ValueOf(std::string_view line, std::string_view key) {
  const auto begin = line.find_first_not_of("/ ");
  if (begin == line.npos || !line.substr(begin).starts_with(key)) return std::nullopt;
  std::string_view value = line.substr(begin + key.size());
  constexpr std::string_view kAround = " :,;\t\"";
  const auto first = value.find_first_not_of(kAround);
  if (first == value.npos || value.find(':') > first) return std::nullopt;
  return std::string(value.substr(first, value.find_last_not_of(kAround) - first + 1));
}

std::optional<double> LeadingNumber(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string StemOf(const std::string& path) { return std::filesystem::path(path).stem().string(); }

std::vector<double> Unwrapped(std::vector<double> counts, double modulus) {
  double last_raw = NAN, last = NAN;
  for (double& count : counts) {
    if (!std::isfinite(count)) continue;
    const double raw = count;
    if (std::isfinite(last)) count = last + Wrapped(raw - last_raw, modulus);
    last_raw = raw;
    last = count;
  }
  return counts;
}

double FromOrigin(double first, double modulus, ExportClock* clock) {
  if (!clock->origin) clock->origin = first;
  return Wrapped(first - *clock->origin, modulus);
}

double FirstFinite(const std::vector<double>& values, const std::string& file,
                   std::string_view name) {
  for (const double value : values)
    if (std::isfinite(value)) return value;
  throw InputError(file, 0, std::string(name) + " is empty; expected a number in each row");
}

double MedianStep(const std::vector<double>& values) {
  std::vector<double> steps;
  double last = NAN;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    if (std::isfinite(last)) steps.push_back(value - last);
    last = value;
  }
  if (steps.empty()) return NAN;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::ranges::nth_element(steps, middle);
  return *middle;
}

double UnitFactor(std::string_view unit, Quantity quantity, const std::string& file,
                  std::size_t line) {
  if (quantity == Quantity::kMagneticField) return 1.0;
  std::vector<std::string_view> known;
  for (const Unit& candidate : kUnits) {
    if (candidate.quantity != quantity) continue;
    if (candidate.name == unit) return candidate.factor;
    known.push_back(candidate.name);
  }
  throw InputError(
      file, line,
      "the unit '" + std::string(unit) + "' is not known; expected one of " + Listed(known));
}

SensorTable::SensorTable(const CsvTable& from) : from_(from) {
  table_.file = from.file;
  table_.rows = from.rows;
  table_.cut_off = from.cut_off;
  table_.first_line = from.first_line;
}

void SensorTable::Add(const std::string& name, std::vector<double> values) {
  table_.names.push_back(name);
  table_.columns.push_back(std::move(values));
}

void SensorTable::AddVector(const std::string& to, const std::array<std::string, 3>& names,
                            double factor) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<double> values = from_.Column(names[axis]);
    for (double& value : values) value *= factor;
    Add(to + "xyz"[axis], std::move(values));
  }
}

std::string ShiftNote(const std::string& name, double period) {
  return name +
         ": a time tag is the end of the interval that its sample averages; all were moved " +
         "back by half a sample, " + Fixed(500.0 * period, 3) + " ms";
}

std::string CentreNote(const std::string& name, std::string_view maker) {
  return name +
         ": a time tag is taken for the centre of the interval that its sample averages, as " +
         std::string(maker) + " does not say";
}

}  // namespace brachium
