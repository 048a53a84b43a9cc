#include "bin/roff.h"

namespace brachium {
namespace {

// Hyphens are escaped lest they become dashes that cannot be pasted into a shell.
std::string Escaped(const std::string& text) {
  std::string escaped;
  for (const char letter : text) {
    if (letter == '\\')
      escaped += "\\e";
    else if (letter == '-')
      escaped += "\\-";
    else if (letter == '\'')
      escaped += "\\(aq";
    else if (letter == '"')
      escaped += "\\(dq";
    else
      escaped += letter;
  }
  return escaped;
}

}  // namespace

std::string RoffLine(const std::string& text) { return "\\&" + Escaped(text) + "\n"; }

std::string RoffQuoted(const std::string& text) { return "\"" + Escaped(text) + "\"\n"; }

}  // namespace brachium
