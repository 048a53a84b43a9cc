#include "io/plot/svg.h"

#include "io/escaped.h"
#include "io/text.h"

namespace brachium {
namespace {

// Hundredths of a pixel, without zeros at the end.
std::string Number(double value) {
  std::string text = Fixed(value, 2);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string Attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + value + "\"";
}

std::string Attribute(const char* name, double value) { return Attribute(name, Number(value)); }

std::string Attributes(const Stroke& stroke) {
  if (stroke.width <= 0.0) return "";
  std::string text = Attribute("stroke", stroke.colour);
  if (stroke.width != 1.0) text += Attribute("stroke-width", stroke.width);
  if (stroke.opacity < 1.0) text += Attribute("stroke-opacity", stroke.opacity);
  if (!stroke.dashes.empty()) text += Attribute("stroke-dasharray", stroke.dashes);
  return text;
}

std::string Attributes(const Fill& fill) {
  std::string text = Attribute("fill", fill.colour);
  if (fill.opacity < 1.0) text += Attribute("fill-opacity", fill.opacity);
  return text;
}

std::string Points(const std::vector<Pixel>& points) {
  std::string text;
  for (const Pixel& point : points) text += Number(point.x) + "," + Number(point.y) + " ";
  if (!text.empty()) text.pop_back();
  return Attribute("points", text);
}

std::string NameOf(TextStyle::Anchor anchor) {
  if (anchor == TextStyle::Anchor::kMiddle) return "middle";
  return anchor == TextStyle::Anchor::kEnd ? "end" : "start";
}

}  // namespace

std::string EscapedXml(std::string_view text) {
  return Escaped(text, {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}});
}

void Svg::Line(const Pixel& from, const Pixel& to, const Stroke& stroke) {
  body_ += "<line" + Attribute("x1", from.x) + Attribute("y1", from.y) + Attribute("x2", to.x) +
           Attribute("y2", to.y) + Attributes(stroke) + "/>\n";
}

void Svg::Polyline(const std::vector<Pixel>& points, const Stroke& stroke) {
  if (points.size() < 2) return;
  body_ += "<polyline fill=\"none\" stroke-linejoin=\"round\"" + Attributes(stroke) +
           Points(points) + "/>\n";
}

void Svg::Polygon(const std::vector<Pixel>& points, const Fill& fill) {
  if (points.size() < 3) return;
  body_ += "<polygon" + Attributes(fill) + Points(points) + "/>\n";
}

void Svg::Rectangle(const Pixel& corner, double width, double height, const Fill& fill,
                    const Stroke& stroke) {
  body_ += "<rect" + Attribute("x", corner.x) + Attribute("y", corner.y) +
           Attribute("width", width) + Attribute("height", height) + Attributes(fill) +
           Attributes(stroke) + "/>\n";
}

void Svg::Circle(const Pixel& centre, double radius, const Fill& fill) {
  body_ += "<circle" + Attribute("cx", centre.x) + Attribute("cy", centre.y) +
           Attribute("r", radius) + Attributes(fill) + "/>\n";
}

void Svg::Text(const Pixel& place, std::string_view text, const TextStyle& style) {
  body_ += "<text" + Attribute("x", place.x) + Attribute("y", place.y) +
           Attribute("text-anchor", NameOf(style.anchor)) + Attribute("font-size", style.size) +
           Attribute("fill", style.colour);
  if (style.bold) body_ += Attribute("font-weight", "bold");
  if (style.turned_deg != 0.0)
    body_ += Attribute("transform", "rotate(" + Number(style.turned_deg) + " " + Number(place.x) +
                                        " " + Number(place.y) + ")");
  body_.append(">").append(EscapedXml(text)).append("</text>\n");
}

void Svg::Picture(const Pixel& corner, const std::string& document) {
  constexpr std::string_view kTag = "<svg";
  body_ += std::string(kTag) + Attribute("x", corner.x) + Attribute("y", corner.y) +
           document.substr(kTag.size());
}

void Svg::BeginClip(const Pixel& corner, double width, double height) {
  body_ += "<svg" + Attribute("x", corner.x) + Attribute("y", corner.y) +
           Attribute("width", width) + Attribute("height", height) +
           Attribute("viewBox", Number(corner.x) + " " + Number(corner.y) + " " + Number(width) +
                                    " " + Number(height)) +
           " overflow=\"hidden\">\n";
}

void Svg::EndClip() { body_ += "</svg>\n"; }

std::string Svg::Document() const {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\"" + Attribute("width", width_) +
         Attribute("height", height_) +
         Attribute("viewBox", "0 0 " + Number(width_) + " " + Number(height_)) +
         " font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\">\n" +
         "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" + body_ + "</svg>\n";
}

}  // namespace brachium
