#include <map>
#include <set>

#include "io/report/html.h"
#include "io/report/series.h"
#include "io/report/tables.h"
#include "io/text.h"

namespace brachium {
namespace {

using Json = nlohmann::ordered_json;

// Members of objects that a file may lack.
const Json& Member(const Json& json, const std::string& key) {
  static const auto* const nothing = new Json();
  if (!json.is_object()) return *nothing;
  const auto found = json.find(key);
  return found == json.end() ? *nothing : *found;
}

std::string TextOf(const Json& json) {
  return json.is_string() ? json.get<std::string>() : json.is_null() ? "–" : json.dump();
}

std::string NumberOf(const Json& json, double unit, int digits) {
  return json.is_number() ? NumberText(json.get<double>() / unit, digits) : "–";
}

// What the tables of a comparison are of: a block of evaluation.json, the figure in it and its unit.
struct ComparedFigure {
  const char *title, *block, *key;
  double unit;
};
constexpr ComparedFigure kFigures[] = {
    {"Rmse of orientations between segments [deg]", "relative", "rmse_deg", 1.0},
    {"Rmse of joint angles [deg]", "joint_angles", "rmse_deg", 1.0},
    {"Rmse of points after one heading and shift [mm]", "positions", "rmse_m", 1e-3}};

std::string CellText(const Json& pair, const ComparedFigure& figure, const std::string& name) {
  if (TextOf(Member(pair, "outcome")) != "done") return TextOf(Member(pair, "outcome"));
  const Json& block = Member(Member(pair, "evaluation"), figure.block);
  const bool trusted = Member(pair, "trusted") != Json(false);
  return NumberOf(Member(Member(block, name), figure.key), figure.unit, 2) + (trusted ? "" : " *");
}

std::string FigureTable(const Json& comparison, const ComparedFigure& figure) {
  std::map<std::pair<std::string, std::string>, const Json*> pairs;  // trial, method
  std::map<std::string, std::set<std::string>> names;                // by trial
  for (const Json& pair : Member(comparison, "pairs")) {
    const std::string trial = TextOf(Member(pair, "trial"));
    pairs[{trial, TextOf(Member(pair, "method"))}] = &pair;
    for (const auto& [name, value] : Member(Member(pair, "evaluation"), figure.block).items())
      names[trial].insert(name);
  }
  std::vector<std::string> header = {"trial", "of"};
  for (const Json& method : Member(comparison, "methods")) header.push_back(TextOf(method));
  HtmlTable table(figure.title, header);
  for (const Json& trial : Member(comparison, "trials"))
    for (const std::string& name : names[TextOf(trial)]) {
      std::vector<std::string> row = {TextOf(trial), Spoken(name)};
      for (const Json& method : Member(comparison, "methods")) {
        const Json* const pair = pairs[{TextOf(trial), TextOf(method)}];
        row.push_back(pair == nullptr ? "–" : CellText(*pair, figure, name));
      }
      table.Add(std::move(row));
    }
  return table.Html();
}

std::vector<std::string> Reasons(const Json& comparison) {
  std::vector<std::string> reasons;
  for (const Json& pair : Member(comparison, "pairs"))
    if (const Json& reason = Member(pair, "reason"); reason.is_string())
      reasons.push_back(TextOf(Member(pair, "method")) + " on " + TextOf(Member(pair, "trial")) +
                        ", " + TextOf(Member(pair, "outcome")) + ": " + TextOf(reason));
  return reasons;
}

std::string PointText(const Json& point) {
  if (!point.is_object()) return "–";
  std::string text;
  for (const auto& [name, value] : point.items())
    text += (text.empty() ? "" : ", ") + name + " = " + TextOf(value);
  return text.empty() ? "as it is" : text;
}

}  // namespace

std::string ComparisonTables(const Json& comparison) {
  std::string html;
  for (const ComparedFigure& figure : kFigures) html += FigureTable(comparison, figure);
  return html + HtmlList("Refused, failed, or not to be trusted (*)", Reasons(comparison));
}

std::string SweepTables(const Json& sweep) {
  HtmlTable counts("Tasks", {"", "number"});
  for (const char* key : {"tasks", "done", "refused", "failed", "missing", "not_trusted"})
    counts.Add({key, TextOf(Member(sweep, key))});
  HtmlTable best("Points of the least mean error, by " + TextOf(Member(sweep, "figure")),
                 {"method", "point", "mean error there", "each trial at the point of the others"});
  for (const Json& method : Member(sweep, "methods"))
    best.Add({TextOf(Member(method, "method")), PointText(Member(method, "overall")),
              NumberOf(Member(method, "overall_mean_error"), 1.0, 3),
              NumberOf(Member(method, "leave_one_trial_out_mean_error"), 1.0, 3)});
  return counts.Html() + best.Html();
}

}  // namespace brachium
