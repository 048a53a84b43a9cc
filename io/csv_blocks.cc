#include "io/csv_blocks.h"

#include <algorithm>
#include <utility>

namespace brachium {
namespace {

constexpr std::size_t kBlock = 1 << 18;        // [byte]
constexpr std::size_t kLongestLine = 1 << 24;  // [byte]; what is longer is no table

bool EndsALine(char c) { return c == '\n' || c == '\r'; }

bool EndsWithABlankLine(std::string_view text) {
  const std::size_t last = text.find_last_not_of("\n\r");
  return std::ranges::count(text.substr(last == text.npos ? 0 : last + 1), '\n') > 1;
}

}  // namespace

CsvBlocks::CsvBlocks(const std::string& file, ColumnFilter wanted,
                     std::function<void(std::string_view)> watch)
    : file_(file), wanted_(std::move(wanted)), watch_(std::move(watch)), parts_(file) {}

bool CsvBlocks::ReadPart() {
  if (read_ == parts_.size()) return false;
  const std::string part = parts_.Read(read_, std::min(kBlock, parts_.size() - read_));
  if (watch_) watch_(part);
  read_ += part.size();
  text_ += part;
  return true;
}

// Up to the last place with a line before and after it that is known not to be blank: blank lines
// are fine at the end of the file alone.
std::size_t CsvBlocks::WholeLines() const {
  for (std::size_t i = text_.size(); i-- > 1;)
    if (text_[i - 1] == '\n' && !EndsALine(text_[i]) &&
        !EndsWithABlankLine(std::string_view(text_).substr(0, i)))
      return i;
  return 0;
}

std::optional<CsvTable> CsvBlocks::Next() {
  const bool is_first = line_ == 1;
  if (text_.empty() && !ReadPart() && !is_first) return std::nullopt;
  std::size_t end = WholeLines();
  while (end == 0 && text_.size() < kLongestLine && ReadPart()) end = WholeLines();
  if (end == 0 || read_ == parts_.size()) end = text_.size();
  const std::string_view block = std::string_view(text_).substr(0, end);
  CsvTable table = is_first
                       ? ParseCsv(block, file_, wanted_)
                       : ParseRows(block, file_, {.names = names_, .first_line = line_}, wanted_);
  names_ = table.names;
  line_ = table.Line(table.rows);
  text_.erase(0, end);
  return table;
}

}  // namespace brachium
