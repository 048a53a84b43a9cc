// Options of several methods behind one set of flags.
#pragma once

#include <map>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "bin/flags.h"
#include "bin/help.h"
#include "bin/options_json.h"
#include "solver/estimators.h"

namespace brachium {

// Default options of a method. Throws UsageError when --FLAG names one that is not known.
MethodOptions OptionsOf(const std::string& flag, const std::string& method);

// The names of all methods, for a help text.
HelpSection MethodList();

// The methods that a comma-separated list of names and patterns ("luinge*") stands for, in the
// order of the list, each once. Throws UsageError for what matches none.
std::vector<std::string> MethodsFrom(const std::string& flag, const std::string& list);

// A flag goes to every method that has an option of that name; `threads` is none of them, because
// every solve has one.
class MethodFlags {
 public:
  // Throws UsageError when --FLAG names a method that is not known.
  MethodFlags(const std::string& flag, const std::vector<std::string>& methods);

  template <typename Visitor>
  static void Visit(MethodFlags& flags, Visitor&& visit) {
    std::set<std::string> seen = {"threads"};
    flags.VisitAll([&](const char* name, auto& field, const char* help) {
      if (seen.insert(name).second) visit(name, field, help);
    });
  }

  // Another default for the option of that name, before the flags are registered.
  void Preset(const std::string& name, const FlagValue& value);

  // Gives what was read to all that have it; each keeps its own default otherwise. Throws UsageError
  // when options contradict themselves.
  void Share();

  const std::vector<MethodOptions>& options() const { return options_; }

 private:
  template <typename Visitor>
  void VisitAll(const Visitor& visit) {
    for (MethodOptions& method : options_)
      std::visit([&](auto& options) { options.Visit(options, visit); }, method);
  }

  std::vector<MethodOptions> options_;
  std::map<std::string, FlagValue> defaults_;  // of the first method with that option
};

nlohmann::ordered_json ToJson(const MethodOptions& method);

}  // namespace brachium
