#include "inspection/svg.hpp"

#include <spdlog/fmt/fmt.h>

#include <array>

#include "text/escape.hpp"

namespace piae::inspection {

namespace {

std::string attributes_of(const Stroke& stroke) {
  return fmt::format(
      "stroke=\"{}\" stroke-width=\"{:g}\"{} fill=\"none\"", stroke.colour, stroke.width,
      stroke.dashes.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", stroke.dashes));
}

}  // namespace

Svg::Svg(double width, double height, const std::string& title)
    : head_(fmt::format(" width=\"{0:g}\" height=\"{1:g}\" "
                        "viewBox=\"0 0 {0:g} {1:g}\" font-family=\"sans-serif\" role=\"img\">\n"
                        "<title>{2}</title>\n"
                        "<rect width=\"{0:g}\" height=\"{1:g}\" fill=\"#ffffff\"/>\n",
                        width, height, text::markup_text(title))) {}

void Svg::line(Point from, Point to, const Stroke& stroke) { polyline({from, to}, stroke); }

void Svg::polyline(const std::vector<Point>& points, const Stroke& stroke) {
  body_ += "<polyline points=\"";
  for (const Point& p : points) body_ += fmt::format("{:.1f},{:.1f} ", p.x, p.y);
  body_ += fmt::format("\" {}/>\n", attributes_of(stroke));
}

void Svg::frame(Point corner, double width, double height) {
  body_ += fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" "
      "stroke=\"#999999\"/>\n",
      corner.x, corner.y, width, height);
}

void Svg::area(Point corner, double width, double height, const std::string& colour) {
  body_ += fmt::format(
      "<rect x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{:.1f}\" fill=\"{}\"/>\n",
      corner.x, corner.y, width, height, colour);
}

void Svg::text(Point at, const std::string& words, Anchor anchor, double size, bool bold) {
  constexpr std::array anchors{"start", "middle", "end"};
  body_ += fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:g}\" text-anchor=\"{}\"{} fill=\"#222222\">{}"
      "</text>\n",
      at.x, at.y, size, anchors.at(static_cast<std::size_t>(anchor)),
      bold ? " font-weight=\"bold\"" : "", text::markup_text(words));
}

std::string Svg::str() const {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\"" + head_ + body_ + "</svg>\n";
}

std::string Svg::element() const { return "<svg" + head_ + body_ + "</svg>\n"; }

}  // namespace piae::inspection
