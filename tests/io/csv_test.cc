#include "io/csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <charconv>
#include <clocale>
#include <cmath>
#include <cstring>
#include <limits>
#include <locale>
#include <random>

#include "io/input_error.h"
#include "io/output_folder.h"
#include "tests/support/temporary_folder.h"

namespace brachium {
namespace {

using testing::ElementsAre, testing::HasSubstr, testing::StartsWith;

std::string Complaint(const std::string& text) {
  try {
    ParseCsv(text, "a.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Csv, ReadsColumnsByNameInAnyOrder) {
  const CsvTable table = ParseCsv("b,time_s,a\n1,0.5,-3e-2\n2,1.5,+4\n", "a.csv");
  EXPECT_EQ(table.rows, 2u);
  EXPECT_THAT(table.Column("time_s"), ElementsAre(0.5, 1.5));
  EXPECT_THAT(table.Column("a"), ElementsAre(-0.03, 4.0));
  EXPECT_THAT(table.Column("b"), ElementsAre(1.0, 2.0));
}

TEST(Csv, ReadsAnEmptyCellAsNaN) {
  const CsvTable table = ParseCsv("a,b,c\n,2,\n1, ,nan\n", "a.csv");
  EXPECT_TRUE(std::isnan(table.Column("a")[0]));
  EXPECT_TRUE(std::isnan(table.Column("c")[0]));
  EXPECT_TRUE(std::isnan(table.Column("b")[1]));
  EXPECT_TRUE(std::isnan(table.Column("c")[1]));
  EXPECT_EQ(table.Column("b")[0], 2.0);
}

TEST(Csv, TakesCarriageReturnsByteOrderMarksQuotedNamesAndBlankLinesAtTheEnd) {
  const CsvTable table = ParseCsv("\xef\xbb\xbf\"a\",b\r\n1,2\r\n3,4\r\n\r\n\n", "a.csv");
  EXPECT_THAT(table.Column("a"), ElementsAre(1.0, 3.0));
  EXPECT_THAT(table.Column("b"), ElementsAre(2.0, 4.0));
  EXPECT_FALSE(table.cut_off);
}

TEST(Csv, KeepsALastRowThatLacksOnlyItsLineEnd) {
  const CsvTable table = ParseCsv("a,b\n1,2\n3,4", "a.csv");
  EXPECT_THAT(table.Column("b"), ElementsAre(2.0, 4.0));
  EXPECT_FALSE(table.cut_off);
}

TEST(Csv, LeavesOutALastRowThatIsCutOff) {
  for (const char* text :
       {"a,b,c\n1,2,3\n4,5", "a,b,c\n1,2,3\n4", "a,b,c\n1,2,3\n4,5,-", "a,b,c\n1,2,3\n4,5,6e"}) {
    const CsvTable table = ParseCsv(text, "a.csv");
    EXPECT_TRUE(table.cut_off) << text;
    EXPECT_EQ(table.rows, 1u) << text;
    EXPECT_THAT(table.Column("c"), ElementsAre(3.0)) << text;
  }
}

TEST(Csv, SkipsColumnsThatNobodyWants) {
  const auto wanted = [](std::string_view name) { return name != "remark"; };
  const CsvTable table = ParseCsv("a,remark,b\n1,left hand,2\n", "a.csv", wanted);
  EXPECT_THAT(table.Column("b"), ElementsAre(2.0));
}

TEST(Csv, NamesFileLineAndColumnOfTextInANumber) {
  EXPECT_EQ(Complaint("a,gyr_x\n1,2\n3,abc\n5,6\n"),
            "a.csv:3: gyr_x is 'abc'; expected a number with a decimal point");
  EXPECT_THAT(Complaint("a,b\n1,2x\n"), StartsWith("a.csv:2: b is '2x'"));
  EXPECT_THAT(Complaint("a,b\n1 2,3\n"), StartsWith("a.csv:2: a is '1 2'"));
  EXPECT_THAT(Complaint("a,b\n0x10,3\n"), StartsWith("a.csv:2: a is '0x10'"));
}

TEST(Csv, NamesRowsOfAnotherLengthThanTheHeader) {
  EXPECT_EQ(Complaint("a,b,c\n1,2,3\n1,2\n1,2,3\n"),
            "a.csv:3: row has 2 cells; expected 3 as in the header");
  EXPECT_EQ(Complaint("a,b,c\n1,2,3,4\n"), "a.csv:2: row has 4 cells; expected 3 as in the header");
  EXPECT_THAT(Complaint("a,b,c\n1,2,3\n\n1,2,3\n"), HasSubstr("a.csv:3: row has 1 cells"));
}

TEST(Csv, SuspectsDecimalCommas) {
  EXPECT_THAT(Complaint("a,b,c\n0,1,0,2,0,3\n"), HasSubstr("[decimal_comma]"));
  EXPECT_THAT(Complaint("a;b;c\n0,1;0,2;0,3\n"), HasSubstr("expected commas, and decimal points"));
}

TEST(Csv, RefusesFilesThatAreNoTables) {
  EXPECT_THAT(Complaint(""), HasSubstr("is empty"));
  EXPECT_THAT(Complaint(std::string("\x7f"
                                    "ELF\0\1\2",
                                    7)),
              HasSubstr("binary"));
  EXPECT_THAT(Complaint("\xff\xfe"
                        "a"),
              HasSubstr("UTF-16"));
  EXPECT_THAT(Complaint("\n1,2\n"), HasSubstr("a.csv:1: has no column names"));
}

TEST(Csv, RefusesAColumnNamedTwice) {
  EXPECT_EQ(Complaint("a,b,a\n1,2,3\n"), "a.csv:1: column 'a' appears twice; expected once");
}

TEST(Csv, SaysWhichColumnIsMissing) {
  const CsvTable table = ParseCsv("time,b\n1,2\n", "a.csv");
  try {
    table.Column("time_s");
    FAIL() << "a missing column went unnoticed";
  } catch (const InputError& error) {
    EXPECT_EQ(error.line(), 1u);
    EXPECT_THAT(error.what(), HasSubstr("column 'time_s' is missing; the header has 'time, b'"));
  }
}

TEST(Csv, ReadsNumbersBeyondTheRangeOfADouble) {
  const CsvTable table = ParseCsv("a,b\n1e999,1e-999\n", "a.csv");
  EXPECT_TRUE(std::isinf(table.Column("a")[0]));
  EXPECT_EQ(table.Column("b")[0], 0.0);
}

class DecimalComma : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

TEST(Csv, ReadsAndWritesPointsInALocaleOfCommas) {
  const TemporaryFolder folder;
  const std::locale before = std::locale::global(std::locale(std::locale(), new DecimalComma));
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  const CsvTable table = ParseCsv("a\n0.5\n", "a.csv");
  WriteCsv(folder.File("n.csv"), 1, {{"a", table.columns[0].data()}});
  std::locale::global(before);
  std::setlocale(LC_ALL, "C");
  EXPECT_THAT(table.Column("a"), ElementsAre(0.5));
  EXPECT_EQ(folder.Read("n.csv"), "a\n0.5\n");
}

TEST(Csv, RefusesWhatIsNotAFile) {
  const TemporaryFolder folder;
  EXPECT_THROW(ReadCsv(folder.path()), InputError);
  EXPECT_THROW(ReadCsv(folder.File("absent.csv")), InputError);
}

TEST(Csv, ReadsBackTheBitsThatItWrote) {
  const TemporaryFolder folder;
  std::mt19937_64 random(3);
  std::vector<double> numbers;  // two columns, interleaved
  while (numbers.size() < 40000) {
    const std::uint64_t bits = random();
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof value);
    numbers.push_back(std::isnan(value) ? 0.1 : value);
  }
  numbers[7] = std::numeric_limits<double>::quiet_NaN();
  numbers[8] = -0.0;
  const std::vector<CsvColumn> columns = {{"a", numbers.data(), 2}, {"b", numbers.data() + 1, 2}};
  WriteCsv(folder.File("n.csv"), numbers.size() / 2, columns);

  const CsvTable table = ReadCsv(folder.File("n.csv"));
  ASSERT_EQ(table.rows, numbers.size() / 2);
  std::vector<double> read;
  for (std::size_t row = 0; row < table.rows; ++row) {
    read.push_back(table.Column("a")[row]);
    read.push_back(table.Column("b")[row]);
  }
  EXPECT_TRUE(std::isnan(read[7]));
  read[7] = numbers[7];
  EXPECT_EQ(std::memcmp(read.data(), numbers.data(), numbers.size() * sizeof(double)), 0);
}

TEST(Csv, WritesEveryNumberAsItsShortestText) {
  std::mt19937_64 random(3);
  std::vector<double> numbers = {0.0,     -0.0,    1e-3,  0.00099, 0.001001,  99999.999999, 1e5,
                                 1e4,     12340.0, 0.1,   -0.5,    1.0000005, 123.456789,   -7e-3,
                                 1e5 - 1, 5e-7,    1e300, -2e-300, 1.0 / 3};
  for (int i = 0; i < 20000; ++i) {
    const double decimals = std::pow(10.0, static_cast<double>(random() % 9));
    const double size = std::pow(10.0, static_cast<double>(random() % 11) - 5.0);
    const double uniform = static_cast<double>(random()) / 0x1p64;
    numbers.push_back(std::round((2 * uniform - 1) * size * decimals) / decimals);
  }
  const TemporaryFolder folder;
  WriteCsv(folder.File("numbers.csv"), numbers.size(), {{"x", numbers.data(), 1}});
  std::string expected = "x\n";
  for (const double number : numbers) {
    char text[32];
    expected.append(text, std::to_chars(text, text + sizeof(text), number).ptr);
    expected += '\n';
  }
  EXPECT_EQ(folder.Read("numbers.csv"), expected);
}

TEST(Csv, WritesNaNAsAnEmptyCell) {
  const TemporaryFolder folder;
  const std::vector<double> a = {1.5, std::nan("")}, b = {std::nan(""), 0.1};
  WriteCsv(folder.File("n.csv"), 2, {{"a", a.data()}, {"b", b.data()}});
  EXPECT_EQ(folder.Read("n.csv"), "a,b\n1.5,\n,0.1\n");
}

TEST(Csv, SaysWhenItCannotWrite) {
  EXPECT_THROW(WriteCsv("/nowhere/at/all.csv", 0, {{"a"}}), OutputError);
}

}  // namespace
}  // namespace brachium
