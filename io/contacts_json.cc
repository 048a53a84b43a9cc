#include "io/contacts_json.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "io/json_defaults.h"
#include "io/protocol_json.h"
#include "io/text.h"

namespace brachium {
namespace {

constexpr std::array<std::string_view, 5> kContactKeys = {"point", "at_s", "place", "sigma_m",
                                                          "axes"};
constexpr std::array kTouching = {Segment::kUpperArm, Segment::kForearm, Segment::kHand};

Segment ParsePoint(const JsonNode& node, const std::set<Segment>& recorded) {
  std::vector<std::string_view> names;
  for (const Segment segment : kTouching) {
    if (!recorded.contains(segment)) continue;
    names.push_back(DistalJointName(segment));
    if (node.Text() == names.back()) return segment;
  }
  node.Fail("is '" + node.Text() +
            "'; expected a point of a segment that is recorded: " + Listed(names));
}

std::vector<double> ParseTimes(const JsonNode& node, const Interval& covered) {
  std::vector<double> times;
  for (const JsonNode& time : node.Elements())
    times.push_back(TimeWithin(covered, time, time.Number()));
  if (times.empty()) node.Fail("is empty; expected the instants of the contact");
  return times;
}

bool ParseHeightOnly(const JsonNode& contact, Findings* findings) {
  const auto axes = contact.Find("axes");
  if (!axes) NoteDefault(contact, "axes", "all", findings);
  if (!axes || axes->Text() == "all") return false;
  if (axes->Text() != "height") axes->Fail("is '" + axes->Text() + "'; expected all or height");
  return true;
}

std::string ParsePlace(const JsonNode& contact, const std::vector<Contact>& before,
                       Findings* findings) {
  const auto node = contact.Find("place");
  const std::string place = node ? node->Text() : "place_" + std::to_string(before.size() + 1);
  if (!node) NoteDefault(contact, "place", place, findings);
  if (place.empty()) node->Fail("is empty; expected a name");
  const bool is_taken =
      std::ranges::any_of(before, [&](const Contact& other) { return other.place == place; });
  if (is_taken)
    (node ? *node : contact)
        .Fail("is the place '" + place + "' again; expected all its instants in one contact");
  return place;
}

}  // namespace

std::vector<Contact> ParseContacts(const JsonNode& trial, const std::set<Segment>& recorded,
                                   const Interval& covered, Findings* findings) {
  std::vector<Contact> contacts;
  const auto list = trial.Find("contacts");
  if (!list) return contacts;
  if (recorded.size() < 2)
    list->Fail(
        "cannot be used: of a recording alone no point of the arm is known; expected two "
        "recordings or more");
  for (const JsonNode& node : list->Elements()) {
    node.WarnOfUnknownKeys(kContactKeys, &findings->warnings);
    contacts.push_back({.place = ParsePlace(node, contacts, findings),
                        .segment = ParsePoint(node.At("point"), recorded),
                        .times = ParseTimes(node.At("at_s"), covered),
                        .sigma = PositiveNumberOr(node, "sigma_m", 0.01, "m", findings),
                        .height_only = ParseHeightOnly(node, findings)});
  }
  return contacts;
}

}  // namespace brachium
