#include "bin/sweep_grid.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <type_traits>

#include "io/text.h"

namespace brachium {
namespace {

constexpr int kMostValues = 100000;
constexpr double kMostPoints = 1e7;

std::vector<std::string> Split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t start = 0;
  for (std::size_t end = text.find(separator); end != std::string::npos;
       end = text.find(separator, start)) {
    parts.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  parts.push_back(text.substr(start));
  return parts;
}

template <typename Number>
std::optional<Number> NumberFrom(const std::string& text) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || rest != end) return std::nullopt;
  return number;
}

std::optional<FlagValue> ValueFrom(const std::string& text, const FlagValue& like) {
  if (std::holds_alternative<double>(like)) {
    const auto number = NumberFrom<double>(text);
    if (number && std::isfinite(*number)) return *number;
  } else if (std::holds_alternative<int>(like)) {
    if (const auto number = NumberFrom<int>(text)) return *number;
  } else if (std::holds_alternative<bool>(like)) {
    if (text == "true" || text == "false") return text == "true";
  } else if (!text.empty()) {
    return text;
  }
  return std::nullopt;
}

std::string Expected(const FlagValue& like) {
  constexpr const char* kExpected[] = {"true or false", "whole numbers", "numbers", "texts"};
  return kExpected[like.index()];
}

// The options of all methods with a value each, for their types. Every solve has one thread.
std::map<std::string, FlagValue> OptionsIn(const std::vector<MethodOptions>& methods) {
  std::map<std::string, FlagValue> options;
  for (const MethodOptions& method : methods)
    std::visit(
        [&](const auto& chosen) {
          chosen.Visit(chosen, [&](const char* name, const auto& field, const char*) {
            options.emplace(name, field);
          });
        },
        method);
  options.erase("threads");
  return options;
}

const FlagValue& KnownOption(const std::map<std::string, FlagValue>& options,
                             const std::string& name) {
  if (const auto found = options.find(name); found != options.end()) return found->second;
  std::vector<std::string_view> names;
  for (const auto& [known, value] : options) names.push_back(known);
  throw UsageError("--vary: no method of this sweep has an option '" + name + "'" +
                   DidYouMean(name, names) + " (see brachium sweep plan --help)");
}

double SixDigits(double value) {
  std::array<char, 40> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, 5)
          .ptr;
  std::from_chars(text.data(), end, value);
  return value;
}

double PointAt(double from, double to, double part, bool logarithmic) {
  return logarithmic ? from * std::pow(to / from, part) : from + part * (to - from);
}

// The texts of a grid's points, or of a list's; none for what is neither.
std::optional<std::vector<std::string>> Texts(const std::string& values, bool numeric) {
  if (!numeric || values.find(':') == std::string::npos) return Split(values, ',');
  const std::vector<std::string> parts = Split(values, ':');
  if (parts.size() != 4) return std::nullopt;
  const auto from = NumberFrom<double>(parts[0]), to = NumberFrom<double>(parts[1]);
  const auto count = NumberFrom<int>(parts[2]);
  const bool logarithmic = parts[3] == "log";
  if (!from || !to || !count || *count < 2 || *count > kMostValues) return std::nullopt;
  if (!std::isfinite(*from) || !std::isfinite(*to) || !std::isfinite(*to - *from))
    return std::nullopt;
  if (!logarithmic && parts[3] != "lin") return std::nullopt;
  if (logarithmic && (*from <= 0.0 || *to <= 0.0)) return std::nullopt;
  std::vector<std::string> texts = {parts[0]};
  for (int i = 1; i + 1 < *count; ++i)
    texts.push_back(Shortest(
        SixDigits(PointAt(*from, *to, static_cast<double>(i) / (*count - 1), logarithmic))));
  texts.push_back(parts[1]);
  return texts;
}

VariedOption ParseOne(const std::string& part, const std::map<std::string, FlagValue>& options) {
  const std::size_t equals = part.find('=');
  if (equals == std::string::npos)
    throw UsageError("--vary: '" + part + "', but NAME=VALUES was expected");
  VariedOption option{.name = part.substr(0, equals), .values = {}};
  const FlagValue& like = KnownOption(options, option.name);
  const bool numeric = std::holds_alternative<double>(like) || std::holds_alternative<int>(like);
  const std::string values = part.substr(equals + 1);
  const auto fail = [&](const std::string& what) {
    throw UsageError("--vary: " + option.name + "=" + values + ": " + what + "; expected " +
                     Expected(like) + " with commas" +
                     (numeric ? ", or from:to:count:spacing with a count of 2 or more and spacing "
                                "lin or log (log: both ends positive)"
                              : ""));
  };
  const auto texts = Texts(values, numeric);
  if (!texts) fail("is no grid");
  for (const std::string& text : *texts) {
    const auto value = ValueFrom(text, like);
    if (!value) fail("'" + text + "' does not fit");
    if (std::find(option.values.begin(), option.values.end(), *value) != option.values.end())
      fail(text + " stands twice");
    option.values.push_back(*value);
  }
  return option;
}

bool Has(const MethodOptions& method, const std::string& name) {
  return OptionsIn({method}).contains(name);
}

void Set(const std::string& name, const FlagValue& value, MethodOptions* method) {
  std::visit(
      [&](auto& options) {
        options.Visit(options, [&](const char* other, auto& field, const char*) {
          if (name == other) field = std::get<std::decay_t<decltype(field)>>(value);
        });
      },
      *method);
}

}  // namespace

std::vector<VariedOption> ParseVary(const std::string& vary,
                                    const std::vector<MethodOptions>& methods) {
  std::vector<VariedOption> varied;
  if (vary.empty()) return varied;
  const auto options = OptionsIn(methods);
  for (const std::string& part : Split(vary, ';')) {
    VariedOption option = ParseOne(part, options);
    for (const VariedOption& earlier : varied)
      if (earlier.name == option.name) throw UsageError("--vary: " + option.name + " stands twice");
    varied.push_back(std::move(option));
  }
  return varied;
}

std::vector<SweepPoint> PointsOf(const MethodOptions& method,
                                 const std::vector<VariedOption>& varied) {
  std::vector<SweepPoint> points = {{.options = method, .varied = {}}};
  for (const VariedOption& option : varied) {
    if (!Has(method, option.name)) continue;
    if (static_cast<double>(points.size()) * static_cast<double>(option.values.size()) >
        kMostPoints)
      throw UsageError("--vary: more than ten million points; fewer were expected");
    std::vector<SweepPoint> finer;
    for (const SweepPoint& point : points)
      for (const FlagValue& value : option.values) {
        finer.push_back(point);
        Set(option.name, value, &finer.back().options);
        finer.back().varied.emplace_back(option.name, value);
      }
    points = std::move(finer);
  }
  for (const SweepPoint& point : points)
    std::visit([](const auto& options) { RequireValid(options); }, point.options);
  return points;
}

}  // namespace brachium
