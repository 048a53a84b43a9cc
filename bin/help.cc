#include "bin/help.h"

#include <iostream>
#include <sstream>

namespace brachium {
namespace {

constexpr std::size_t kWidth = 88;

std::string Kind(const Flag& flag) {
  constexpr const char* kKinds[] = {"true or false", "whole number", "number", "text"};
  return kKinds[flag.field.index()];
}

std::string Describe(const Flag& flag) {
  const std::string value = Text(flag.default_value);
  const std::string heading =
      "  --" + flag.name + "  (" + Kind(flag) + (value.empty() ? "" : ", default " + value) + ")\n";
  return heading + Wrap(flag.help, 6);
}

}  // namespace

std::string Wrap(const std::string& text, std::size_t indent) {
  std::istringstream words(text);
  std::string wrapped, line, word;
  while (words >> word) {
    if (!line.empty() && indent + line.size() + 1 + word.size() > kWidth) {
      wrapped += std::string(indent, ' ') + line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return line.empty() ? wrapped : wrapped + std::string(indent, ' ') + line + "\n";
}

std::string HelpText(const CommandLine& line, const CommandHelp& help) {
  std::string text =
      "usage: brachium " + line.command() + " " + help.usage + "\n\n" + Wrap(help.description, 0);
  std::string group;
  for (const Flag& flag : line.flags()) {
    if (flag.group != group) text += "\n" + flag.group + ":\n";
    group = flag.group;
    text += Describe(flag);
  }
  return text +
         "\nAny of:\n  --flagfile=FILE  reads flags from a file, one a line.\n"
         "  --help           shows this.\n";
}

bool ShowHelp(const CommandLine& line, const CommandHelp& help) {
  if (line.AsksForHelp()) std::cout << HelpText(line, help);
  return line.AsksForHelp();
}

}  // namespace brachium
