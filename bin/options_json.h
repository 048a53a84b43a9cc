// Option structs as JSON objects, by the names that their flags have.
#pragma once

#include <nlohmann/json.hpp>

namespace brachium {

template <typename Options>
nlohmann::ordered_json ToJson(const Options& options) {
  auto json = nlohmann::ordered_json::object();
  Options::Visit(options,
                 [&](const char* name, const auto& value, const char*) { json[name] = value; });
  return json;
}

}  // namespace brachium
