// Text as roff, the language of manual pages, takes it.
#pragma once

#include <string>

namespace brachium {

// A paragraph of plain text, and its end of line; nothing in it is taken for a request.
std::string RoffLine(const std::string& text);

// One argument of a request, in quotes, and its end of line.
std::string RoffQuoted(const std::string& text);

}  // namespace brachium
