// brachium man: the manual page, made of the help of all commands.
#include <iostream>

#include "bin/commands.h"
#include "bin/help.h"
#include "bin/roff.h"
#include "bin/run_facts.h"

namespace brachium {
namespace {

const CommandHelp kHelp = {
    "", "Prints the manual page of the program and all its commands, as man(1) reads it."};

void PrintHead() {
  std::cout << ".TH BRACHIUM 1 \"\" " << RoffQuoted("brachium " + ProgramVersion()) << ".SH NAME\n"
            << RoffLine("brachium - arm motion from inertial sensors") << ".SH SYNOPSIS\n.B "
            << RoffQuoted("brachium COMMAND --flag=value ...") << ".SH DESCRIPTION\n"
            << RoffLine(kPurpose);
  for (const Command& command : Commands())
    std::cout << ".TP\n.B " << RoffQuoted(std::string(command.name)) << RoffLine(command.summary);
  std::cout << ".SH EXIT STATUS\n" << RoffLine(kExitCodes);
}

}  // namespace

int RunMan(CommandLine& line) {
  if (ShowHelp(line, kHelp)) return kGood;
  line.Read();
  PrintHead();
  for (const Command& command : Commands()) {
    CommandLine asking(std::string(command.name), {kAskManual});
    command.run(asking);
  }
  return kGood;
}

}  // namespace brachium
