// The manual page, against the help that it is made of.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iterator>
#include <regex>
#include <sstream>

#include "tests/support/run_program.h"

namespace brachium {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

// The words before two blanks or the end of each line that is indented by two.
std::vector<std::string> Items(const std::string& text) {
  std::vector<std::string> items;
  const std::regex item("\n  ([^ \n]+(?: [^ \n]+)?)(?=  |\n)");
  for (std::sregex_iterator it(text.begin(), text.end(), item), end; it != end; ++it)
    items.push_back((*it)[1]);
  return items;
}

class Man : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    const std::string roff = RunWell({"man"});
    Write("page", roff);
    page_ = std::regex_replace(roff, std::regex(R"(\\-)"), "-");
  }

  // Whether the shell finds `program`.
  static bool IsThere(const std::string& program) {
    return std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
  }

  std::string page_;  // with plain hyphens
};

TEST_F(Man, NamesEveryCommandAndEveryFlag) {
  const std::vector<std::string> commands = Items(Run({"help"}).out);
  ASSERT_GT(commands.size(), 14u);
  for (const std::string& command : commands) {
    if (command == "help" || command == "version") continue;
    const std::size_t start = page_.find(".SH \"brachium " + command + "\"");
    ASSERT_NE(start, page_.npos) << command;
    const std::string section = page_.substr(start, page_.find("\n.SH", start) - start);
    std::istringstream words(command);
    std::vector<std::string> asking{std::istream_iterator<std::string>(words), {}};
    asking.push_back("--help");
    const std::vector<std::string> items = Items(Run(asking).out);
    EXPECT_GE(items.size(), 2u) << command;
    for (const std::string& item : items)
      EXPECT_NE(section.find("\"" + item), section.npos) << command << ": " << item;
  }
}

TEST_F(Man, NamesTheFlagsOfEveryMethod) {
  for (const std::string method : {"zhou", "bai_kinematic", "heading_corrected", "luinge_rts"})
    for (const std::string& item : Items(Run({"reconstruct", "--method=" + method, "--help"}).out))
      EXPECT_NE(page_.find("\"" + item), page_.npos) << method << ": " << item;
}

TEST_F(Man, IsReadWithoutAComplaint) {
  if (!IsThere("groff")) GTEST_SKIP() << "groff is not here";
  const std::string folder = Path("");
  const std::string command = "groff -man -Tutf8 -ww '" + folder + "page' >'" + folder +
                              "read' 2>'" + folder + "complaints'";
  EXPECT_EQ(std::system(command.c_str()), 0);
  EXPECT_THAT(ReadText(Path("complaints")), IsEmpty());
  EXPECT_THAT(ReadText(Path("read")), HasSubstr("Shows this."));
}

}  // namespace
}  // namespace brachium
