#include "io/report/html.h"

#include <cmath>

#include "io/escaped.h"
#include "io/file_bytes.h"
#include "io/plot/svg.h"
#include "io/text.h"

namespace brachium {
namespace {

std::string Cell(const std::string& tag, const std::string& scope, const std::string& text) {
  const std::string attribute = scope.empty() ? "" : " scope=\"" + scope + "\"";
  return "<" + tag + attribute + ">" + EscapedHtml(text) + "</" + tag + ">";
}

std::string HeaderRow(const std::vector<std::string>& names) {
  std::string html = "<tr>";
  for (const std::string& name : names) html += Cell("th", "col", name);
  return html + "</tr>";
}

std::string Row(const std::vector<std::string>& cells) {
  std::string html = "<tr>";
  for (std::size_t i = 0; i < cells.size(); ++i)
    html += i == 0 ? Cell("th", "row", cells[i]) : Cell("td", "", cells[i]);
  return html + "</tr>\n";
}

char HexDigits(char high, char low) {
  const auto value = [](char digit) { return digit <= '9' ? digit - '0' : digit - 'a' + 10; };
  return static_cast<char>(16 * value(high) + value(low));
}

}  // namespace

std::string EscapedHtml(std::string_view text) { return EscapedXml(text); }

std::string HtmlTable::Html() const {
  if (rows_.empty()) return "";
  std::string html = "<div class=\"wide\"><table>\n<caption>" + EscapedHtml(caption_) +
                     "</caption>\n<thead>" + HeaderRow(header_) + "</thead>\n<tbody>\n";
  for (const auto& row : rows_) html += Row(row);
  return html + "</tbody></table></div>\n";
}

std::string HtmlList(const std::string& heading, const std::vector<std::string>& sentences) {
  if (sentences.empty()) return "";
  std::string html = "<h4>" + EscapedHtml(heading) + "</h4>\n<ul>\n";
  for (const std::string& sentence : sentences) html += "<li>" + EscapedHtml(sentence) + "</li>\n";
  return html + "</ul>\n";
}

std::string ScriptData(const std::string& id, const nlohmann::ordered_json& json) {
  const std::string text =
      json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  std::string html = "<script type=\"application/json\" id=\"" + id + "\">";
  html += Escaped(text, {{'<', "\\u003c"}});
  return html + "</script>\n";
}

std::string Base64(std::string_view bytes) {
  constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(4 * (bytes.size() + 2) / 3);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = 256u * group + (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : kLetters[group >> (6 * (3 - k)) & 63u];
  }
  return text;
}

std::string PolicyHash(std::string_view text) {
  const std::string hex = Sha256(text);
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2) bytes += HexDigits(hex[i], hex[i + 1]);
  return "'sha256-" + Base64(bytes) + "'";
}

std::string NumberText(double value, int digits) {
  if (!std::isfinite(value)) return "–";
  const std::string text = Fixed(value, digits);
  return text.find_first_of("123456789") == std::string::npos ? Fixed(0.0, digits) : text;
}

}  // namespace brachium
