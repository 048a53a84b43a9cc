// Drawing into scalable vector graphics, in pixels from the upper left corner. The same drawing is
// the same bytes, and holds no identifiers, so that several can stand in one page.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace brachium {

struct Pixel {
  double x = 0.0, y = 0.0;
};

struct Stroke {
  std::string colour = "#000000";
  double width = 1.0;
  double opacity = 1.0;
  std::string dashes{};  // lengths of dash and gap, "4 3"; empty: solid
};

struct Fill {
  std::string colour = "none";
  double opacity = 1.0;
};

struct TextStyle {
  enum class Anchor { kStart, kMiddle, kEnd };
  Anchor anchor = Anchor::kStart;
  double size = 12.0;
  double turned_deg = 0.0;  // clockwise, about its place
  bool bold = false;
  std::string colour = "#222222";
};

class Svg {
 public:
  Svg(double width, double height) : width_(width), height_(height) {}

  void Line(const Pixel& from, const Pixel& to, const Stroke& stroke);
  void Polyline(const std::vector<Pixel>& points, const Stroke& stroke);  // nothing below two
  void Polygon(const std::vector<Pixel>& points, const Fill& fill);
  void Rectangle(const Pixel& corner, double width, double height, const Fill& fill,
                 const Stroke& stroke);
  void Circle(const Pixel& centre, double radius, const Fill& fill);
  void Text(const Pixel& place, std::string_view text, const TextStyle& style);

  // Another document, in its own size, with its upper left corner at that place.
  void Picture(const Pixel& corner, const std::string& document);

  // What is drawn up to EndClip() is cut at this frame; its coordinates stay the same.
  void BeginClip(const Pixel& corner, double width, double height);
  void EndClip();

  // The document; without its XML declaration, so that it can also stand in HTML.
  std::string Document() const;

 private:
  double width_, height_;
  std::string body_;
};

// With the characters that XML keeps to itself spelled out.
std::string EscapedXml(std::string_view text);

}  // namespace brachium
