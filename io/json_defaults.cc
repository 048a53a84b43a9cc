#include "io/json_defaults.h"

#include "io/text.h"

namespace brachium {

void NoteDefault(const JsonNode& node, const std::string& key, const std::string& value,
                 Findings* findings) {
  const std::string prefix = node.path().empty() ? "" : node.path() + ".";
  findings->defaults.push_back(prefix + key + " = " + value);
}

double NumberOr(const JsonNode& node, const std::string& key, double absent,
                const std::string& unit, Findings* findings) {
  if (const auto value = node.Find(key)) return value->Number();
  NoteDefault(node, key, Shortest(absent) + " " + unit, findings);
  return absent;
}

double PositiveNumberOr(const JsonNode& node, const std::string& key, double absent,
                        const std::string& unit, Findings* findings) {
  if (const auto value = node.Find(key)) return value->PositiveNumber();
  NoteDefault(node, key, Shortest(absent) + " " + unit, findings);
  return absent;
}

}  // namespace brachium
