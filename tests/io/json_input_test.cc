#include "io/json_input.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "io/input_error.h"

namespace brachium {
namespace {

using testing::HasSubstr, testing::StartsWith;

constexpr const char* kText = R"({
  "arm": {
    "side": "right",
    "length": -1
  },
  "list": [
    {"a": 1},
    {"a": "x",
     "b": [1, 2,
           "y"]}
  ]
})";

template <typename Action>
std::string Complaint(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string SyntaxComplaint(const std::string& text) {
  return Complaint([&text] { JsonNode::Parse(text, "t.json"); });
}

TEST(JsonInput, NamesLineAndPathOfAWrongValue) {
  const JsonNode root = JsonNode::Parse(kText, "t.json");
  const JsonNode arm = root.At("arm");
  EXPECT_EQ(Complaint([&] { arm.At("length").PositiveNumber(); }),
            "t.json:4: arm.length is -1; expected a number greater than zero");
  EXPECT_EQ(Complaint([&] { arm.At("side").Number(); }),
            "t.json:3: arm.side is \"right\"; expected a number");
  const JsonNode second = root.At("list").Elements()[1];
  EXPECT_EQ(Complaint([&] { second.At("a").Number(); }),
            "t.json:8: list[1].a is \"x\"; expected a number");
  EXPECT_THAT(Complaint([&] { second.At("b").Numbers(3); }), StartsWith("t.json:9: list[1].b[2]"));
  EXPECT_THAT(Complaint([&] { second.At("b").Numbers(4); }),
              HasSubstr("has 3 numbers; expected 4"));
}

TEST(JsonInput, NamesTheObjectThatLacksAMember) {
  const JsonNode root = JsonNode::Parse(kText, "t.json");
  EXPECT_EQ(Complaint([&] { root.At("arm").At("elbow"); }),
            "t.json:2: arm.elbow is missing; it is required");
  EXPECT_EQ(Complaint([&] { root.At("list").Elements()[1].At("file"); }),
            "t.json:8: list[1].file is missing; it is required");
}

TEST(JsonInput, NamesTheLineOfASyntaxError) {
  EXPECT_THAT(SyntaxComplaint("{\n \"a\": 1,\n \"b\": }\n"),
              StartsWith("t.json:3: is not valid JSON"));
  EXPECT_THAT(SyntaxComplaint("{\n \"a\": 1e999\n}"), StartsWith("t.json:2: is not valid JSON"));
  EXPECT_THAT(SyntaxComplaint("{\"a\": 1"), StartsWith("t.json:1: is not valid JSON"));
  EXPECT_THAT(SyntaxComplaint("{} {}"), StartsWith("t.json:1: is not valid JSON"));
  EXPECT_THAT(SyntaxComplaint("\x80\x81"), HasSubstr("is not valid JSON"));
  EXPECT_THAT(SyntaxComplaint(""), HasSubstr("is empty"));
}

TEST(JsonInput, RefusesAKeyGivenTwiceAndADepthWithoutEnd) {
  EXPECT_EQ(SyntaxComplaint("{\"a\": 1,\n\"a\": 2}"), "t.json:2: a is given twice; expected once");
  EXPECT_THAT(SyntaxComplaint(std::string(100000, '[')), HasSubstr("nested"));
}

TEST(JsonInput, TakesNullForAbsent) {
  const JsonNode root = JsonNode::Parse("{\"a\": null}", "t.json");
  EXPECT_FALSE(root.Has("a"));
  EXPECT_FALSE(root.Find("b").has_value());
}

TEST(JsonInput, NamesUnknownKeysWithTheNearestKnownOne) {
  constexpr std::array<std::string_view, 2> kKnown = {"side", "length_m"};
  std::vector<std::string> warnings;
  JsonNode::Parse(kText, "folder/t.json").At("arm").WarnOfUnknownKeys(kKnown, &warnings);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0],
            "t.json:4: arm.length is not a known key and was ignored; did you mean 'length_m'?");
}

}  // namespace
}  // namespace brachium
