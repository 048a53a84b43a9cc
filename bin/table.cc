#include "bin/table.h"

#include <algorithm>

#include "bin/help.h"

namespace brachium {
namespace {

std::string Blanks(std::size_t width, const std::string& cell) {
  return std::string(width - cell.size(), ' ');
}

}  // namespace

std::string Table::Text() const {
  std::vector<std::size_t> widths(rows_.front().size(), 0);
  for (const auto& row : rows_)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string text;
  for (const auto& row : rows_) {
    text += "  " + row[0] + (row.size() > 1 ? Blanks(widths[0], row[0]) : "");
    for (std::size_t i = 1; i < row.size(); ++i) text += "  " + Blanks(widths[i], row[i]) + row[i];
    text += "\n";
  }
  return text;
}

std::string Listing(const std::string& title, const std::vector<std::string>& sentences) {
  if (sentences.empty()) return "";
  std::string text = title + "\n";
  for (const std::string& sentence : sentences) text += "  -" + Wrap(sentence, 4).substr(3);
  return text;
}

}  // namespace brachium
