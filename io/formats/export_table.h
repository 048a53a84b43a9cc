// What the readers of makers' exports share: header lines, counters that wrap, units, columns.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats/export_format.h"

namespace brachium {

// A text line by line.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}

  bool AtEnd() const { return rest_.empty(); }
  std::size_t number() const { return number_; }  // of the line that Next() gave last, from 1 on
  std::string_view rest() const { return rest_; }

  // The next line without its end and without blanks behind; empty at the end of the text.
  std::string_view Next();

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

// Of tab, comma, semicolon and space, the one that the line has most of.
char DelimiterOf(std::string_view line);

// What follows `key` and a colon, blanks and delimiters aside; absent where the line does not begin
// with the key.
std::optional<std::string> ValueOf(std::string_view line, std::string_view key);

// The number that the text begins with: 100 of "100.0Hz".
std::optional<double> LeadingNumber(std::string_view text);

// The file's name without folder and extension.
std::string StemOf(const std::string& path);

// A counter that wraps to 0 at `modulus`, as numbers that go on; what is not finite stays.
std::vector<double> Unwrapped(std::vector<double> counts, double modulus);

// A counter's distance from the trial's beginning, which the first file sets; both wrap at
// `modulus`, so a sensor that starts within half of it before or after is placed rightly.
double FromOrigin(double first, double modulus, ExportClock* clock);

// The first of the values that is finite, and the median difference of the finite ones.
double FirstFinite(const std::vector<double>& values, const std::string& file,
                   std::string_view name);
double MedianStep(const std::vector<double>& values);

// SI units in a unit that text names ("deg/s", "g"). Throws InputError for one that is not known.
enum class Quantity { kAngularRate, kAcceleration, kMagneticField, kTime };
double UnitFactor(std::string_view unit, Quantity quantity, const std::string& file,
                  std::size_t line);

// The table of a sensor in the making: columns are taken from a table of the export.
class SensorTable {
 public:
  explicit SensorTable(const CsvTable& from);

  void Add(const std::string& name, std::vector<double> values);

  // `to`x, `to`y, `to`z from three columns. Throws InputError where one is missing.
  void AddVector(const std::string& to, const std::array<std::string, 3>& names, double factor);

  CsvTable Take() { return std::move(table_); }

 private:
  const CsvTable& from_;
  CsvTable table_;
};

// "NAME: time tags are taken for ..., and were moved back by HALF ms".
std::string ShiftNote(const std::string& name, double period);
std::string CentreNote(const std::string& name, std::string_view maker);

}  // namespace brachium
