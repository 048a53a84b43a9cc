#include "bin/method_flags.h"

#include <fnmatch.h>

#include <algorithm>
#include <string_view>

#include "bin/lists.h"
#include "io/text.h"

namespace brachium {

MethodOptions OptionsOf(const std::string& flag, const std::string& method) {
  if (const auto options = DefaultOptions(method)) return *options;
  const std::vector<std::string> names = MethodNames();
  const std::vector<std::string_view> known(names.begin(), names.end());
  throw UsageError("--" + flag + "=" + method + " is not known" + DidYouMean(method, known) +
                   " (known: " + Listed(known) + ")");
}

HelpSection MethodList() {
  HelpSection list{"Methods", {}};
  for (const std::string& name : MethodNames()) list.items.push_back({name, ""});
  return list;
}

std::vector<std::string> MethodsFrom(const std::string& flag, const std::string& list) {
  std::vector<std::string> methods;
  const auto add = [&](const std::string& name) {
    if (std::find(methods.begin(), methods.end(), name) == methods.end()) methods.push_back(name);
  };
  for (const std::string& item : SplitList(list)) {
    bool matched = false;
    for (const std::string& name : MethodNames())
      if (fnmatch(item.c_str(), name.c_str(), 0) == 0) {
        add(name);
        matched = true;
      }
    if (!matched) OptionsOf(flag, item);
  }
  return methods;
}

MethodFlags::MethodFlags(const std::string& flag, const std::vector<std::string>& methods) {
  for (const std::string& method : methods) options_.push_back(OptionsOf(flag, method));
  VisitAll(
      [&](const char* name, const auto& field, const char*) { defaults_.emplace(name, field); });
}

void MethodFlags::Preset(const std::string& name, const FlagValue& value) {
  VisitAll([&](const char* other, auto& field, const char*) {
    if (name == other) field = std::get<std::decay_t<decltype(field)>>(value);
  });
  if (const auto found = defaults_.find(name); found != defaults_.end()) found->second = value;
}

void MethodFlags::Share() {
  std::map<std::string, FlagValue> values;
  VisitAll([&](const char* name, const auto& field, const char*) { values.emplace(name, field); });
  VisitAll([&](const char* name, auto& field, const char*) {
    const FlagValue& value = values.at(name);
    if (value != defaults_.at(name)) field = std::get<std::decay_t<decltype(field)>>(value);
  });
  for (const MethodOptions& method : options_)
    std::visit([](const auto& options) { RequireValid(options); }, method);
}

nlohmann::ordered_json ToJson(const MethodOptions& method) {
  return std::visit([](const auto& options) { return ToJson(options); }, method);
}

}  // namespace brachium
