// brachium COMMAND --flag=value...: finds the command, runs it, and turns what went wrong into one
// message and an exit code.
#include <glog/logging.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include "bin/commands.h"
#include "bin/run_facts.h"
#include "bin/termination.h"
#include "io/input_error.h"
#include "io/output_folder.h"
#include "io/text.h"

namespace brachium {
namespace {

std::string Overview() {
  std::string text =
      std::string(kPurpose) + "\n\nusage: brachium COMMAND --flag=value ...\n\ncommands:\n";
  for (const Command& command : Commands())
    text += "  " + std::string(command.name) + std::string(14 - command.name.size(), ' ') +
            command.summary + "\n";
  return text +
         "  help          shows this\n"
         "  version       shows the version\n\n"
         "brachium COMMAND --help describes the command and its flags.\n"
         "Exit codes: " +
         kExitCodes + "\n";
}

bool AsksHelp(const std::vector<std::string>& words) {
  return std::find(words.begin(), words.end(), "--help") != words.end();
}

void JoinSweep(std::string* name, std::vector<std::string>* words) {
  if (*name != "sweep" || words->empty() || words->front().starts_with("-")) return;
  *name += " " + words->front();
  words->erase(words->begin());
}

int RunCommand(const std::string& name, const std::vector<std::string>& words) {
  std::vector<std::string_view> names;
  for (const Command& command : Commands()) {
    names.push_back(command.name);
    if (command.name != name) continue;
    CommandLine line(name, words);
    return command.run(line);
  }
  if (name == "sweep") throw UsageError("expected sweep plan, run, status, merge or submit");
  throw UsageError("unknown command '" + name + "'" + DidYouMean(name, names) +
                   " (see brachium help)");
}

int Dispatch(std::vector<std::string> words) {
  if (words.empty()) {
    std::cerr << Overview();
    return kWrongUsage;
  }
  std::string name = words.front();
  words.erase(words.begin());
  const bool asks_help = name == "help" || name == "--help" || name == "-h";
  if (asks_help && !words.empty()) {
    name = words.front();
    words.erase(words.begin());
    JoinSweep(&name, &words);
    words = {"--help"};
  } else {
    JoinSweep(&name, &words);
  }
  if (name == "--help" || name == "-h" || name == "help" || (name == "sweep" && AsksHelp(words))) {
    std::cout << Overview();
    return kGood;
  }
  if (name == "version" || name == "--version") {
    std::cout << "brachium " << ProgramVersion() << "\n";
    return kGood;
  }
  return RunCommand(name, words);
}

int Complain(const std::exception& error, int exit_code) {
  std::cerr << "brachium: " << error.what() << "\n";
  return exit_code;
}

// A broken promise inside the program: its message is enough, a stack trace helps nobody here.
void QuitOnBrokenCheck() { std::_Exit(kWrongUsage); }

// Memory is taken from the system in large pieces and kept for the next use: a trial's many short
// buffers would be given back, mapped and put to zero again and again, a tenth of all time.
void KeepMemory() {
#if defined(__GLIBC__)
  mallopt(M_TOP_PAD, 1 << 24);
  mallopt(M_MMAP_THRESHOLD, 1 << 25);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
#endif
}

void StartLogging(const char* program) {
  FLAGS_logtostderr = true;
  FLAGS_minloglevel = google::GLOG_ERROR;
  google::InitGoogleLogging(program);
  google::InstallFailureFunction(QuitOnBrokenCheck);
}

}  // namespace

int Main(const std::vector<std::string>& words) try {
  const int exit_code = Dispatch(words);
  std::cout.flush();
  if (!std::cout) throw OutputError("standard output cannot be written");
  return exit_code;
} catch (const InputError& error) {
  return Complain(error, kWrongInput);
} catch (const std::bad_alloc&) {
  return Complain(
      OutputError("there is not enough memory; `reconstruct --whole_trial=false` needs little for "
                  "a long trial"),
      kWrongUsage);
} catch (const std::exception& error) {
  return Complain(error, kWrongUsage);
}

}  // namespace brachium

int main(int argc, char** argv) {
  brachium::KeepMemory();
  brachium::ExitOnTermination();
  brachium::StartLogging(argv[0]);
  return brachium::Main({argv + 1, argv + argc});
}
