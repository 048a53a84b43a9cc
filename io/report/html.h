// Pieces of HTML. Text from files is never taken for markup.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace brachium {

// With the characters that HTML keeps to itself spelled out, for text and for attributes in ".
std::string EscapedHtml(std::string_view text);

// A table with a heading; the first cell of each row names it.
class HtmlTable {
 public:
  HtmlTable(std::string caption, std::vector<std::string> header)
      : caption_(std::move(caption)), header_(std::move(header)) {}

  void Add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

  std::string Html() const;  // nothing without a row

 private:
  std::string caption_;
  std::vector<std::string> header_;
  std::vector<std::vector<std::string>> rows_;
};

// A list of sentences below a heading; nothing when there are none.
std::string HtmlList(const std::string& heading, const std::vector<std::string>& sentences);

// Data that scripts read: <script type="application/json" id="ID">. No text in it can end it.
std::string ScriptData(const std::string& id, const nlohmann::ordered_json& json);

std::string Base64(std::string_view bytes);

// How a content policy names an inline script or style: 'sha256-...'.
std::string PolicyHash(std::string_view text);

// With that many digits after the point; a dash for what is not finite.
std::string NumberText(double value, int digits);

}  // namespace brachium
