#pragma once

#include <string>
#include <vector>

namespace piae::inspection {

/// Style of a line. The colours are those of Okabe and Ito, which people with the usual colour
/// blindnesses can distinguish. Dashes distinguish lines without colour.
struct Stroke {
  std::string colour;
  double width = 1;
  std::string dashes = {};  ///< SVG's stroke-dasharray: "6 3"; empty: solid
};

struct Point {
  double x = 0;
  double y = 0;
};

enum class Anchor { start, middle, end };

/// A drawing of lines and text on white, in pixels from the top left corner. The same calls give
/// the same bytes.
class Svg {
 public:
  Svg(double width, double height, const std::string& title);

  void line(Point from, Point to, const Stroke& stroke);
  void polyline(const std::vector<Point>& points, const Stroke& stroke);
  void frame(Point corner, double width, double height);
  /// Draws a filled rectangle without an edge.
  void area(Point corner, double width, double height, const std::string& colour);
  /// Draws a text. `y` is its baseline.
  void text(Point at, const std::string& words, Anchor anchor = Anchor::start, double size = 11,
            bool bold = false);

  /// Returns the whole file.
  [[nodiscard]] std::string str() const;
  /// Returns the drawing as an element of an HTML page, where it does not need a namespace.
  [[nodiscard]] std::string element() const;

 private:
  std::string head_;
  std::string body_;
};

}  // namespace piae::inspection
