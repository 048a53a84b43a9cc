// Help texts: what commands there are, and what flags a command has.
#pragma once

#include <string>

#include "bin/flags.h"

namespace brachium {

struct CommandHelp {
  std::string usage;        // "--trial=DIR --output=DIR"
  std::string description;  // a few sentences, wrapped here
};

// Usage, description, and each registered flag with its default and help, under its heading.
std::string HelpText(const CommandLine& line, const CommandHelp& help);

// Shows the help on standard output if the command line asks for it; whether it did.
bool ShowHelp(const CommandLine& line, const CommandHelp& help);

// `text` in lines of at most 88 characters, each indented by `indent` blanks.
std::string Wrap(const std::string& text, std::size_t indent);

}  // namespace brachium
