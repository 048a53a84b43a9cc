#include "bin/help.h"

#include <iostream>
#include <sstream>

#include "bin/roff.h"

namespace brachium {
namespace {

constexpr std::size_t kWidth = 88;

std::string Kind(const Flag& flag) {
  constexpr const char* kKinds[] = {"true or false", "whole number", "number", "text"};
  return kKinds[flag.field.index()];
}

HelpItem Describe(const Flag& flag) {
  const std::string value = Text(flag.default_value);
  const std::string standard = value.empty() ? "" : ", default " + value;
  return {"--" + flag.name + "  (" + Kind(flag) + standard + ")", flag.help};
}

std::vector<HelpSection> SectionsOf(const CommandLine& line) {
  std::vector<HelpSection> sections;
  for (const Flag& flag : line.flags()) {
    if (sections.empty() || sections.back().heading != flag.group)
      sections.push_back({flag.group, {}});
    sections.back().items.push_back(Describe(flag));
  }
  sections.push_back(
      {"Any of",
       {{"--flagfile=FILE", "Reads flags from a file, one a line."}, {"--help", "Shows this."}}});
  return sections;
}

std::string HelpText(const std::string& usage, const std::string& description,
                     const std::vector<HelpSection>& sections) {
  std::string text = "usage: " + usage + "\n\n" + Wrap(description, 0);
  for (const HelpSection& section : sections) {
    text += "\n" + section.heading + ":\n";
    for (const HelpItem& item : section.items) text += "  " + item.name + "\n" + Wrap(item.text, 6);
  }
  return text;
}

std::string ManualText(const std::string& name, const std::string& usage,
                       const std::string& description, const std::vector<HelpSection>& sections) {
  std::string text =
      ".SH " + RoffQuoted(name) + ".B " + RoffQuoted(usage) + ".PP\n" + RoffLine(description);
  for (const HelpSection& section : sections) {
    text += ".SS " + RoffQuoted(section.heading);
    for (const HelpItem& item : section.items) {
      const std::string term = ".B " + RoffQuoted(item.name);
      text += item.text.empty() ? ".br\n" + term : ".TP\n" + term + RoffLine(item.text);
    }
  }
  return text;
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

bool ShowHelp(const CommandLine& line, const CommandHelp& help,
              const std::vector<HelpSection>& lists) {
  if (!line.AsksForHelp()) return false;
  const std::string name = "brachium " + line.command();
  const std::string usage = name + (help.usage.empty() ? "" : " " + help.usage);
  std::vector<HelpSection> sections = SectionsOf(line);
  sections.insert(sections.end(), lists.begin(), lists.end());
  std::cout << (line.AsksForManual() ? ManualText(name, usage, help.description, sections)
                                     : HelpText(usage, help.description, sections));
  return true;
}

}  // namespace brachium
