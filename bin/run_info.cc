#include "bin/run_info.h"

#include <utility>

#include "bin/method_flags.h"
#include "bin/run_facts.h"

namespace brachium {

RunInfo RunInfoOf(const TrialFolder& folder, const MethodOptions& method,
                  std::vector<NameValue> flags, const std::string& command_line,
                  double reading_seconds) {
  return {.trial = folder.trial.name,
          .options = ToJson(method),
          .flags = std::move(flags),
          .findings = folder,
          .recordings = folder.recordings,
          .inputs = folder.inputs,
          .versions = Versions(),
          .stages = {{"reading", reading_seconds}},
          .host = HostName(),
          .command_line = command_line};
}

}  // namespace brachium
