#include "bin/roff.h"

#include "io/escaped.h"

namespace brachium {
namespace {

// Hyphens too, lest they become dashes that cannot be pasted into a shell.
std::string EscapedRoff(const std::string& text) {
  return Escaped(text, {{'\\', "\\e"}, {'-', "\\-"}, {'\'', "\\(aq"}, {'"', "\\(dq"}});
}

}  // namespace

std::string RoffLine(const std::string& text) {
  return std::string("\\&").append(EscapedRoff(text)).append("\n");
}

std::string RoffQuoted(const std::string& text) {
  return std::string("\"").append(EscapedRoff(text)).append("\"\n");
}

}  // namespace brachium
