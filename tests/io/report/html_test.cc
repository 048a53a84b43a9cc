#include "io/report/html.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace brachium {
namespace {

using nlohmann::ordered_json;
using testing::HasSubstr, testing::Not;

TEST(Html, TakesNoTextForMarkup) {
  HtmlTable table("a < b", {"x", "y"});
  table.Add({"<b>", "\"&\""});
  EXPECT_THAT(table.Html(), HasSubstr("a &lt; b"));
  EXPECT_THAT(table.Html(), HasSubstr("<td>&quot;&amp;&quot;</td>"));
  EXPECT_THAT(HtmlList("notes", {"<script>alert(1)</script>"}), Not(HasSubstr("<script>")));
}

TEST(Html, LeavesOutEmptyTablesAndLists) {
  EXPECT_EQ(HtmlTable("nothing", {"x"}).Html(), "");
  EXPECT_EQ(HtmlList("nothing", {}), "");
}

TEST(Html, KeepsDataFromEndingTheirScript) {
  const ordered_json json = {
      {"name", "</script><!--"}, {"broken", "\xff"}, {"value", std::nan("")}};
  const std::string html = ScriptData("d", json);
  EXPECT_EQ(html.find("</script>"), html.rfind("</script>"));
  EXPECT_THAT(html, Not(HasSubstr("<!--")));
  const std::size_t begin = html.find('>') + 1, end = html.rfind("</script>");
  const auto read = ordered_json::parse(html.substr(begin, end - begin));
  EXPECT_EQ(read["name"], "</script><!--");
  EXPECT_TRUE(read["value"].is_null());
}

TEST(Html, WritesBytesInBase64) {
  EXPECT_EQ(Base64(""), "");
  EXPECT_EQ(Base64("M"), "TQ==");
  EXPECT_EQ(Base64("Ma"), "TWE=");
  EXPECT_EQ(Base64("Man"), "TWFu");
  EXPECT_EQ(Base64(std::string("\xff\x00\xfe", 3)), "/wD+");
}

TEST(Html, NamesScriptsByTheirChecksum) {
  EXPECT_EQ(PolicyHash("alert('Hello, world.');"),
            "'sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng='");
}

TEST(Html, ShowsWhatIsNotFiniteAsADashAndNoNegativeZero) {
  EXPECT_EQ(NumberText(1.256, 2), "1.26");
  EXPECT_EQ(NumberText(std::nan(""), 2), "–");
  EXPECT_EQ(NumberText(-1e-9, 2), "0.00");
}

}  // namespace
}  // namespace brachium
