// What packed series hold (io/report/packed.h).
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace brachium {

inline std::string FromBase64(const std::string& text) {
  constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int held = 0;
  for (const char letter : text) {
    const std::size_t value = kLetters.find(letter);
    if (value == kLetters.npos) break;
    bits = bits << 6 | static_cast<unsigned>(value);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes.push_back(static_cast<char>(bits >> held & 255u));
  }
  return bytes;
}

template <typename Number>
std::vector<Number> Numbers(const std::string& base64) {
  const std::string bytes = FromBase64(base64);
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  if (!numbers.empty()) std::memcpy(numbers.data(), bytes.data(), bytes.size());
  return numbers;
}

template <typename Whole>
std::vector<double> UnpackedAs(const nlohmann::ordered_json& packed) {
  std::vector<double> values;
  for (const Whole part : Numbers<Whole>(packed["data"].get<std::string>()))
    values.push_back(packed["offset"].get<double>() + packed["unit"].get<double>() * part);
  return values;
}

inline std::vector<double> Unpacked(const nlohmann::ordered_json& packed) {
  std::vector<double> values = UnpackedAs<std::int16_t>(packed);
  const auto parts = Numbers<std::int16_t>(packed["data"].get<std::string>());
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (parts[i] == INT16_MIN) values[i] = std::nan("");
  return values;
}

inline std::vector<double> UnpackedTimes(const nlohmann::ordered_json& packed) {
  return UnpackedAs<std::uint32_t>(packed);
}

}  // namespace brachium
