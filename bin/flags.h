// Options structs as command-line flags. A struct names its fields once, in a static template
// Visit(options, visit) that calls visit(name, field, help); from that come the gflags flags, the
// help, run.flags and the options in summary.json.
#pragma once

#include <deque>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace brachium {

// The command line is wrong; the message says how.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A value as it stood when its flag was registered. gflags keeps pointers, hence the variant.
using FlagValue = std::variant<bool, int, double, std::string>;
using FlagField = std::variant<bool*, int*, double*, std::string*>;

// As one writes it in a flag: true, 4, 0.05, text. Doubles are the shortest that read back the
// same.
std::string Text(const FlagValue& value);

struct Flag {
  std::string name;
  std::string help;
  std::string group;  // the heading under which help shows it
  FlagField field;
  FlagValue default_value;

  FlagValue Value() const;
};

// Asks a command for its help as a part of the manual page.
inline constexpr const char* kAskManual = "--help=man";

// The words after `brachium COMMAND`. Flags are registered first, then read; the option structs
// must live until the program ends, because gflags keeps pointers to their fields.
class CommandLine {
 public:
  // Reads the files that --flagfile names: one flag a line, empty lines and # comments aside.
  // Throws UsageError when such a file cannot be read.
  CommandLine(std::string command, const std::vector<std::string>& words);

  // Registers every field of `options` under the heading `group`.
  template <typename Options>
  void Add(const std::string& group, Options& options) {
    Options::Visit(options, [&](const char* name, auto& field, const char* help) {
      Register(group, name, &field, help);
    });
  }

  // What --name would be set to, before any flag is registered: a method brings flags of its own.
  std::string Peek(const std::string& name, const std::string& default_value) const;

  // Whether --help or -h is among the words, or kAskManual.
  bool AsksForHelp() const;
  bool AsksForManual() const;

  // Registers the flags with gflags and sets the fields. Throws UsageError for an unknown flag, naming
  // its neighbours, for a value that does not parse, and for a word that is no flag.
  void Read();

  // Names and values of all flags but `without`: what a flag file needs to repeat the run.
  std::vector<std::pair<std::string, std::string>> RunFlags(
      const std::vector<std::string>& without) const;

  const std::string& command() const { return command_; }
  std::string text() const;  // as it was typed
  const std::deque<Flag>& flags() const { return flags_; }

 private:
  struct Word {
    std::string text;
    std::string origin;  // "FILE:LINE: " for a word from a flagfile
  };

  void Expand(const std::vector<std::string>& words, int depth);
  void ExpandFile(const std::string& path, int depth);
  void Register(const std::string& group, const char* name, FlagField field, const char* help);
  void RegisterWithGflags(Flag& flag) const;
  const Flag* Find(const std::string& name) const;
  const Flag* FindNegated(const std::string& name) const;
  std::size_t ReadFlag(std::size_t word);
  void Set(const Flag& flag, const std::string& value, const std::string& origin) const;
  [[noreturn]] void RefuseUnknown(const Word& word, const std::string& name) const;

  std::string command_;
  std::vector<std::string> typed_;
  std::vector<Word> words_;
  std::deque<Flag> flags_;  // a deque: gflags keeps pointers to names and defaults
};

// Throws UsageError when a text that the command cannot do without is empty.
void RequireGiven(const std::string& value, const std::string& name);

// Throws UsageError with the reason when options contradict themselves.
template <typename Options>
void RequireValid(const Options& options) {
  if (std::string why; !options.IsValid(&why)) throw UsageError(why);
}

}  // namespace brachium
