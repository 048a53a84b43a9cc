// Text for languages in which some letters mean something else.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace brachium {

// The text with each letter that has another spelling spelled so.
inline std::string Escaped(std::string_view text,
                           std::initializer_list<std::pair<char, const char*>> spellings) {
  std::string escaped;
  for (const char letter : text) {
    const char* spelling = nullptr;
    for (const auto& [special, other] : spellings)
      if (letter == special) spelling = other;
    if (spelling == nullptr)
      escaped += letter;
    else
      escaped += spelling;
  }
  return escaped;
}

}  // namespace brachium
