#include "io/report/page.h"

#include <algorithm>
#include <set>
#include <utility>

#include "io/plot/svg.h"
#include "io/report/charts_json.h"
#include "io/report/comparison.h"
#include "io/report/figures.h"
#include "io/report/html.h"
#include "io/report/replay_json.h"
#include "io/report/replay_section.h"
#include "io/report/series.h"
#include "io/report/tables.h"

namespace brachium {
namespace {

// How much of each estimate is shown. Series and frames of all together take about so many bytes:
constexpr double kBytesOfSeries = 1.3e6, kBytesOfFrames = 1.6e6;
constexpr double kMostSamples = 5000.0, kFewest = 600.0;

struct Detail {
  std::size_t samples, frames;
};

Detail DetailOf(const std::vector<ReportedEstimate>& estimates) {
  double series = 0.0, frame = 0.0;  // bytes a sample, bytes a frame
  for (const ReportedEstimate& reported : estimates) {
    const auto angles = static_cast<double>(ShownAngles(reported.estimate).size());
    const auto joints = static_cast<double>(reported.estimate.p_W.size());
    const auto segments = static_cast<double>(reported.estimate.q_WB.size());
    series += 45.0 * angles + 60.0;
    frame += 8.0 * angles + 16.0 * joints + 22.0 * segments + 19.0;
  }
  return {static_cast<std::size_t>(std::clamp(kBytesOfSeries / series, kFewest, kMostSamples)),
          static_cast<std::size_t>(std::max(kBytesOfFrames / frame, kFewest))};
}

constexpr std::size_t kMostPictures = 2'000'000;  // bytes of pictures out of folders

class Page {
 public:
  Page(const Report& report, const PageFiles& files)
      : report_(report), files_(files), detail_(DetailOf(report.estimates)) {}

  ReportPage Make() {
    const std::string body = Body();
    return {.html = Head() + body, .figures = std::move(figures_)};
  }

 private:
  std::string Title() const {
    std::set<std::string> names;
    for (const ReportedEstimate& reported : report_.estimates) names.insert(reported.run.trial);
    for (const ReportedFolder& folder : report_.folders) names.insert(folder.name);
    std::string title;
    for (const std::string& name : names) title += (title.empty() ? "" : ", ") + name;
    return title;
  }

  std::string Script() const {
    std::string script = std::string(files_.plot_script) + "\n";
    for (const std::string_view part : {files_.packed, files_.charts, files_.scene, files_.replay})
      script += part;
    return script;
  }
  std::string Style() const {
    return std::string(files_.plot_style) + "\n" + std::string(files_.style);
  }

  std::string Head() const {
    return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
           "base-uri 'none'; form-action 'none'; img-src data:; style-src " +
           PolicyHash(Style()) + "; script-src " + PolicyHash(Script()) +
           "\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<meta name=\"generator\" content=\"brachium " +
           EscapedHtml(report_.version) + "\">\n<title>" + EscapedHtml(Title()) +
           " – brachium report</title>\n<style>" + Style() + "</style>\n</head>\n";
  }

  std::string Body() {
    const std::string comparison = ComparisonSection();
    std::string html =
        "<body>\n<a class=\"skip\" href=\"#main\">To the contents</a>\n<header><h1>" +
        EscapedHtml(Title()) + "</h1>\n<p class=\"small\">Report of brachium " +
        EscapedHtml(report_.version) + "." + StaticNote() + "</p>\n" +
        Navigation(!comparison.empty()) + "</header>\n<main id=\"main\">\n" +
        ReplaySection(report_) + comparison;
    for (std::size_t e = 0; e < report_.estimates.size(); ++e) html += EstimateSection(e);
    for (std::size_t f = 0; f < report_.folders.size(); ++f) html += FolderSection(f);
    return html + "</main>\n" + Replays() + Licence() + "<script>" + Script() +
           "</script>\n</body>\n</html>\n";
  }

  std::string StaticNote() const {
    return files_.plot_script.empty()
               ? " Built without uPlot: its charts are pictures and cannot be zoomed."
               : "";
  }

  std::string Navigation(bool compares) const {
    std::string html = "<nav aria-label=\"Contents\"><ul>\n";
    const auto add = [&](const std::string& id, const std::string& name) {
      html += "<li><a href=\"#" + id + "\">" + EscapedHtml(name) + "</a></li>\n";
    };
    if (!report_.estimates.empty()) add("replay", "Replay");
    if (compares) add("comparison", "Side by side");
    for (std::size_t e = 0; e < report_.estimates.size(); ++e)
      add("estimate-" + std::to_string(e), report_.estimates[e].name);
    for (std::size_t f = 0; f < report_.folders.size(); ++f)
      add("folder-" + std::to_string(f), report_.folders[f].name);
    return html + "</ul></nav>\n";
  }

  // Chart by chart, so that a page of paper ends between two.
  static std::string Pictures(const ReportFigure& figure) {
    if (figure.charts.empty()) return figure.svg;
    std::string pictures;
    for (const std::string& svg : DrawEach(figure.charts, figure.size)) pictures += svg;
    return pictures;
  }

  // A figure below its heading; nothing when there is nothing in it.
  std::string FigureHtml(const std::string& heading, const ReportFigure& figure,
                         const std::string& prefix, const std::string& estimate) {
    if (figure.svg.empty()) return "";
    const std::string id = prefix + "-" + figure.name;
    figures_[SafeFileName(id) + ".svg"] = figure.svg;
    const std::string number = std::to_string(count_++);
    const bool live = !figure.charts.empty() && !files_.plot_script.empty();
    std::string html = heading.empty() ? "" : "<h3>" + EscapedHtml(heading) + "</h3>\n";
    html += "<figure id=\"figure-" + number + "\"";
    if (live) html += " data-charts=\"charts-" + number + "\"";
    if (!estimate.empty()) html += " data-estimate=\"" + estimate + "\"";
    html += ">\n<div class=\"live\"></div><div class=\"picture\" role=\"img\" aria-label=\"" +
            EscapedHtml(figure.caption) + "\">" + Pictures(figure) + "</div>\n<figcaption>" +
            EscapedHtml(figure.caption) + "</figcaption></figure>\n";
    if (live) html += ScriptData("charts-" + number, ChartsJson(figure.charts, detail_.samples));
    return html;
  }

  std::string EstimateSection(std::size_t e) {
    const ReportedEstimate& reported = report_.estimates[e];
    const std::string number = std::to_string(e);
    const auto figure = [&](const std::string& heading, const ReportFigure& of) {
      return FigureHtml(heading, of, reported.run.trial + "-" + reported.label, number);
    };
    const auto part = [](const std::string& heading, const std::string& html) {
      return html.empty() ? "" : "<h3>" + heading + "</h3>\n" + html;
    };
    std::string html = "<section id=\"estimate-" + number + "\">\n<h2>" +
                       EscapedHtml(reported.name) + "</h2>\n" + FactsHtml(reported) +
                       RemarksHtml(reported);
    html += figure("Angles", AnglesFigure(reported, detail_.samples));
    html += part("Errors against the reference", ErrorTables(reported));
    html += figure("", ErrorsFigure(reported, detail_.samples));
    html += figure("Agreement with the reference", AgreementFigure(reported));
    html += part("Movements", MovementTables(reported));
    html += figure("Place", PointFigure(reported, detail_.samples));
    html += figure("Observability: what held the headings", ObservabilityFigure(reported));
    html += part("Constants", ConstantTable(reported));
    html += figure("Residuals", ResidualsFigure(reported));
    html += Folded("Residuals as numbers", ResidualTable(reported));
    return html + "</section>\n";
  }

  static std::string Folded(const std::string& summary, const std::string& html) {
    return html.empty() ? ""
                        : "<details><summary>" + summary + "</summary>\n" + html + "</details>\n";
  }

  std::string ComparisonSection() {
    const SideBySide side_by_side = SideBySideOf(report_.estimates);
    std::string html;
    for (const auto& [trial, estimates] : side_by_side.by_trial)
      html += FigureHtml("Angles, " + trial, OverlaidAnglesFigure(estimates, detail_.samples),
                         trial, "");
    if (!side_by_side.comparison.methods.empty()) html += ComparedHtml(side_by_side.comparison);
    return html.empty()
               ? html
               : "<section id=\"comparison\">\n<h2>Side by side</h2>\n" + html + "</section>\n";
  }

  std::string ComparedHtml(const Comparison& comparison) {
    std::string html =
        "<h3>Errors</h3>\n" +
        ComparisonTables(nlohmann::ordered_json::parse(ComparisonJson(comparison, {})));
    for (const auto& [name, svg] : ComparisonFigures(comparison))
      html += FigureHtml(
          "",
          {.name = name.substr(0, name.rfind('.')), .caption = ComparisonCaption(name), .svg = svg},
          "comparison", "");
    return html;
  }

  std::string FolderSection(std::size_t f) {
    const ReportedFolder& folder = report_.folders[f];
    const bool sweep = folder.kind == ReportedFolder::Kind::kSweep;
    std::string html = "<section id=\"folder-" + std::to_string(f) + "\">\n<h2>" +
                       EscapedHtml((sweep ? "Sweep " : "Comparison ") + folder.name) + "</h2>\n" +
                       (sweep ? SweepTables(folder.json) : ComparisonTables(folder.json));
    std::vector<std::string> left_out;
    for (const auto& [name, svg] : folder.pictures) {
      if (pictures_ + svg.size() > kMostPictures) {
        left_out.push_back(name);
        continue;
      }
      pictures_ += svg.size();
      const std::string caption = EscapedHtml(sweep ? SweepCaption(name) : ComparisonCaption(name));
      html += "<figure><div class=\"picture\"><img alt=\"" + caption +
              "\" src=\"data:image/svg+xml;base64," + Base64(svg) + "\"></div>\n<figcaption>" +
              caption + "</figcaption></figure>\n";
    }
    return html + HtmlList("Pictures in the folder that would make this page too large", left_out) +
           "</section>\n";
  }

  std::string Replays() const {
    std::string html;
    for (std::size_t e = 0; e < report_.estimates.size(); ++e)
      html += ScriptData("replay-" + std::to_string(e),
                         ReplayJson(report_.estimates[e], detail_.frames));
    return html;
  }

  std::string Licence() const {
    if (files_.plot_licence.empty()) return "";
    return "<details class=\"small\"><summary>Charts by uPlot</summary><pre>" +
           EscapedHtml(files_.plot_licence) + "</pre></details>\n";
  }

  const Report& report_;
  const PageFiles& files_;
  Detail detail_;
  std::map<std::string, std::string> figures_;
  int count_ = 0;
  std::size_t pictures_ = 0;  // bytes so far
};

}  // namespace

ReportPage PageOf(const Report& report, const PageFiles& files) {
  return Page(report, files).Make();
}

}  // namespace brachium
