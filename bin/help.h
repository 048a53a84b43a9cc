// Help texts: what flags a command has and what they mean, for the terminal and for the manual page.
#pragma once

#include <string>
#include <vector>

#include "bin/flags.h"

namespace brachium {

struct CommandHelp {
  std::string usage;        // "--trial=DIR --output=DIR"
  std::string description;  // a few sentences, wrapped here
};

struct HelpItem {
  std::string name, text;
};

struct HelpSection {
  std::string heading;
  std::vector<HelpItem> items;
};

// Shows the help on standard output if the command line asks for it; whether it did. Usage,
// description, each registered flag with its default and help under its heading, then `lists`.
bool ShowHelp(const CommandLine& line, const CommandHelp& help,
              const std::vector<HelpSection>& lists = {});

// `text` in lines of at most 88 characters, each indented by `indent` blanks.
std::string Wrap(const std::string& text, std::size_t indent);

}  // namespace brachium
