#include "io/csv.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <span>

#include "io/file_bytes.h"
#include "io/input_error.h"
#include "io/text.h"

namespace brachium {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::string_view Trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

// Text of the file as an error may show it: short and printable.
std::string Shown(std::string_view cell, std::size_t longest = 40) {
  std::string text(cell.substr(0, longest));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) c = '?';
  return "'" + text + (cell.size() > longest ? "...'" : "'");
}

void RefuseBinary(std::string_view text, const std::string& file) {
  if (text.empty()) throw InputError(file, 0, "is empty; expected a header line and rows");
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
    throw InputError(file, 0, "is UTF-16 text; expected UTF-8 (save it again as UTF-8)");
  const auto is_control = [](char c) {
    return static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r';
  };
  if (std::ranges::any_of(text.substr(0, 4096), is_control))
    throw InputError(file, 0, "is a binary file; expected comma-separated text");
}

void CheckDelimiter(std::string_view header, const std::string& file) {
  if (header.find(',') == std::string_view::npos &&
      header.find_first_of(";\t") != std::string_view::npos)
    throw InputError(file, 1,
                     "columns are parted by semicolons or tabs; expected commas, and decimal "
                     "points in the numbers");
}

void CheckNames(const CsvTable& table) {
  const std::size_t line = table.first_line - 1;
  std::vector<std::string_view> sorted(table.names.begin(), table.names.end());
  std::erase(sorted, "");
  if (sorted.empty()) throw InputError(table.file, line, "has no column names; expected a header");
  std::ranges::sort(sorted);
  const auto twice = std::ranges::adjacent_find(sorted);
  if (twice != sorted.end())
    throw InputError(table.file, line, "column " + Shown(*twice) + " appears twice; expected once");
}

// The number that a whole cell spells, NaN when the cell is empty. A number that no double can hold
// becomes zero or infinite.
bool ParseCell(std::string_view cell, std::string_view missing, double* value) {
  *value = kNaN;
  if (cell.empty() || cell == missing) return true;
  const char* const end = cell.data() + cell.size();
  const bool plus = cell.front() == '+' && cell.size() > 1 && cell[1] != '-';
  const auto [at, error] = std::from_chars(cell.data() + (plus ? 1 : 0), end, *value);
  if (at != end || error == std::errc::invalid_argument) return false;
  if (error != std::errc::result_out_of_range) return true;
  const bool tiny = cell.find("e-") != cell.npos || cell.find("E-") != cell.npos;
  *value = tiny ? 0.0 : std::numeric_limits<double>::infinity();
  return true;
}

constexpr std::string_view kDecimalComma =
    "; decimal commas, as it seems: write decimal points [decimal_comma]";

class Rows {
 public:
  Rows(std::string_view text, const CsvLayout& layout, CsvTable* table, std::vector<bool> wanted)
      : at_(text.data()),
        end_(text.data() + text.size()),
        delimiter_(layout.delimiter),
        missing_(layout.missing),
        spare_delimiter_(layout.spare_delimiter),
        table_(*table),
        wanted_(wanted.begin(), wanted.end()),
        row_(table->names.size(), kNaN) {}

  void Read() {
    Reserve();
    while (at_ < end_ && !OnlyBlankLinesLeft()) {
      if (!ReadRow()) {
        table_.cut_off = true;
        return;
      }
      for (std::size_t c = 0; c < row_.size(); ++c)
        if (wanted_[c]) table_.columns[c].push_back(row_[c]);
      ++table_.rows;
    }
  }

 private:
  void Reserve() {
    const auto length = static_cast<std::size_t>(std::find(at_, end_, '\n') - at_ + 1);
    const auto rows = static_cast<std::size_t>(end_ - at_) / std::max(length, row_.size()) + 1;
    for (std::size_t c = 0; c < row_.size(); ++c)
      if (wanted_[c]) table_.columns[c].reserve(rows);
  }

  bool OnlyBlankLinesLeft() const {
    if (*at_ != '\n' && *at_ != '\r') return false;
    return std::all_of(at_, end_, [](char c) { return c == '\n' || c == '\r'; });
  }

  // False: the row is the last and was cut off.
  bool ReadRow() {
    row_begin_ = at_;
    const std::size_t last = row_.size() - 1;
    for (std::size_t c = 0; c <= last; ++c) {
      const char* const cell_end = wanted_[c] ? ReadCell(c) : CellEnd();
      if (cell_end == nullptr) return false;
      at_ = cell_end;
      bool delimited = at_ != end_ && *at_ == delimiter_;
      if (delimited && c == last && EndsAt(at_ + 1)) {
        at_ = std::find(at_, end_, '\n');
        delimited = false;
      }
      if (delimited == (c == last)) return delimited ? FailLength() : EndsEarly();
      if (delimited) ++at_;
    }
    if (at_ != end_) ++at_;
    return true;
  }

  bool EndsAt(const char* p) const {
    return spare_delimiter_ && (p == end_ || *p == '\n' || *p == '\r');
  }

  const char* CellEnd() const {
    const char* p = at_;
    while (p != end_ && *p != delimiter_ && *p != '\n') ++p;
    return p;
  }

  // The cell's end, or nullptr where the file breaks off within it.
  const char* ReadCell(std::size_t c) {
    const auto [p, error] = std::from_chars(at_, end_, row_[c]);
    if (error == std::errc() && p != end_ && (*p == delimiter_ || *p == '\n')) return p;
    const char* const cell_end = CellEnd();
    const std::string_view cell = Trimmed({at_, cell_end});
    if (ParseCell(cell, missing_, &row_[c])) return cell_end;
    if (cell_end == end_ && cell.find_first_not_of("0123456789+-.eE") == cell.npos) return nullptr;
    Fail(table_.names[c] + " is " + Shown(cell) + "; expected a number with a decimal point" +
         (HasDecimalComma(cell) ? std::string(kDecimalComma) : ""));
  }

  static bool HasDecimalComma(std::string_view cell) {
    return std::ranges::count(cell, ',') == 1 &&
           cell.find_first_not_of("0123456789+-,eE") == cell.npos;
  }

  bool EndsEarly() const { return at_ == end_ ? false : FailLength(); }

  [[noreturn]] bool FailLength() const {
    const auto row_end = std::find(row_begin_, end_, '\n');
    const auto cells = static_cast<std::size_t>(std::count(row_begin_, row_end, delimiter_)) + 1;
    std::string what = "row has " + std::to_string(cells) + " cells; expected " +
                       std::to_string(row_.size()) + " as in the header";
    if (Trimmed({row_begin_, row_end}).empty()) what += " (the line is blank)";
    if (delimiter_ == ',' && cells >= 2 * row_.size() - 1) what += kDecimalComma;
    Fail(what);
  }

  [[noreturn]] void Fail(const std::string& what) const {
    throw InputError(table_.file, table_.Line(table_.rows), what);
  }

  const char* at_;
  const char* const end_;
  const char delimiter_;
  const std::string_view missing_;
  const bool spare_delimiter_;
  const char* row_begin_ = nullptr;
  CsvTable& table_;
  const std::vector<char> wanted_;
  std::vector<double> row_;
};

}  // namespace

bool CsvTable::Has(std::string_view name) const {
  return std::ranges::find(names, name) != names.end();
}

const std::vector<double>& CsvTable::Column(std::string_view name) const {
  const auto found = std::ranges::find(names, name);
  if (found != names.end()) return columns[static_cast<std::size_t>(found - names.begin())];
  const std::vector<std::string_view> present(names.begin(), names.end());
  throw InputError(file, 1,
                   "column '" + std::string(name) + "' is missing; the header has " +
                       Shown(Listed(present), 200));
}

std::string_view PlainText(std::string_view text, const std::string& file) {
  RefuseBinary(text, file);
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  return text;
}

std::vector<std::string> SplitCells(std::string_view line, char delimiter) {
  std::vector<std::string> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(delimiter, begin), line.size());
    std::string_view cell = Trimmed(line.substr(begin, end - begin));
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
      cell = cell.substr(1, cell.size() - 2);
    cells.emplace_back(cell);
    begin = end + 1;
  }
  return cells;
}

CsvTable ParseRows(std::string_view text, const std::string& file, CsvLayout layout,
                   const ColumnFilter& wanted) {
  CsvTable table;
  table.file = file;
  table.names = std::move(layout.names);
  table.first_line = layout.first_line;
  CheckNames(table);
  table.columns.resize(table.names.size());
  std::vector<bool> chosen;
  for (const std::string& name : table.names)
    chosen.push_back(!name.empty() && (!wanted || wanted(name)));
  Rows(text, layout, &table, std::move(chosen)).Read();
  return table;
}

CsvTable ParseCsv(std::string_view text, const std::string& file, const ColumnFilter& wanted) {
  text = PlainText(text, file);
  const std::string_view header = text.substr(0, text.find('\n'));
  CheckDelimiter(header, file);
  text.remove_prefix(std::min(header.size() + 1, text.size()));
  return ParseRows(text, file, {.names = SplitCells(header, ','), .first_line = 2}, wanted);
}

CsvTable ReadCsv(const std::string& file, const ColumnFilter& wanted) {
  return ParseCsv(FileBytes(file).text(), file, wanted);
}

}  // namespace brachium
