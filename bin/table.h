// A table for the terminal.
#pragma once

#include <string>
#include <vector>

namespace brachium {

// The first column stands to the left, the others to the right.
class Table {
 public:
  explicit Table(std::vector<std::string> header) : rows_{std::move(header)} {}

  // As many cells as the header has, or fewer.
  void Add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

  bool empty() const { return rows_.size() == 1; }
  std::string Text() const;  // each line indented by two blanks

 private:
  std::vector<std::vector<std::string>> rows_;
};

// "TITLE" and its sentences below, wrapped and indented; nothing when there are none.
std::string Listing(const std::string& title, const std::vector<std::string>& sentences);

}  // namespace brachium
