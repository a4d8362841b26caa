#include "page/compact_svg.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "page/svg_path.hpp"
#include "page/xml.hpp"

namespace piae::page {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string rewritten(const std::string& path) {
  const auto lines = parse_path(path);
  return lines ? path_text(*lines) : "not understood";
}

TEST(SvgPath, GoesFromPointToPointInTenths) {
  // Rounded first, then subtracted: (83.5, 524), (740.9, 524), (740.9, 500).
  EXPECT_EQ(rewritten("M83.52,523.95 L740.94,523.95 L740.9,500  "), "M83.5 524l657.4 0 0-24");
  EXPECT_EQ(rewritten("M1,2 L3,4 M5,6 L7,8"), "M1 2l2 2m2 2 2 2");
  EXPECT_EQ(rewritten("M1,1 L2,1 L2,2 Z M0,0 L.5,0"), "M1 1l1 0 0 1zm-1-1 .5 0");
  EXPECT_EQ(rewritten("M1 1l1 0 0 1zl1 1"), "M1 1l1 0 0 1zm0 0 1 1");
}

TEST(SvgPath, WhatItWroteItReads) {
  for (const char* path :
       {"M83.5 524l657.4 0 0-24", "M1 2l2 2m2 2 2 2", "M1 1l1 0 0 1zm-1-1 .5 0"}) {
    EXPECT_EQ(rewritten(path), path);
  }
}

TEST(SvgPath, RoundingDoesNotAddUpAlongALine) {
  std::string path = "M0,0";
  for (int i = 1; i <= 100; ++i)
    path += " L" + std::to_string(0.26 * i) + "," + std::to_string(i % 2);
  const auto lines = parse_path(rewritten(path));
  ASSERT_TRUE(lines.has_value());
  EXPECT_EQ(lines->front().points.back(), (TenthsPoint{260, 0}));
}

TEST(SvgPath, UnderstandsNoOtherCommands) {
  for (const char* path :
       {"M-1,0 h2 M0,-1 v2", "L1,2", "M1", "M0,0 C1,1 2,2 3,3", "1 2", "M1 1z2 2"}) {
    EXPECT_FALSE(parse_path(path).has_value()) << path;
  }
}

std::vector<TenthsPoint> kept_of(const std::vector<TenthsPoint>& points) {
  return simplified({.points = points}).points;
}

TEST(SvgPath, LeavesOutPointsThatNobodySees) {
  EXPECT_THAT(kept_of({{0, 0}, {10, 1}, {20, 0}, {30, 0}}),
              ElementsAre(TenthsPoint{0, 0}, TenthsPoint{30, 0}));
  EXPECT_THAT(kept_of({{0, 0}, {10, 2}, {20, 0}}),
              ElementsAre(TenthsPoint{0, 0}, TenthsPoint{10, 2}, TenthsPoint{20, 0}));
}

TEST(SvgPath, KeepsASpikeThatGoesBackTheWayItCame) {
  EXPECT_THAT(kept_of({{0, 0}, {90, 0}, {10, 0}}),
              ElementsAre(TenthsPoint{0, 0}, TenthsPoint{90, 0}, TenthsPoint{10, 0}));
}

TEST(SvgPath, ALongCurveStaysWithinATenth) {
  std::vector<TenthsPoint> circle;
  for (int i = 0; i <= 360; ++i) {
    const double angle = i * std::acos(-1.0) / 180;
    circle.push_back({std::llround(3000 * std::cos(angle)), std::llround(3000 * std::sin(angle))});
  }
  const auto kept = kept_of(circle);
  EXPECT_LT(kept.size(), 200U);
  // Between two kept points the arc rises above the chord by at most one tenth, and rounding adds
  // one.
  for (std::size_t i = 0; i + 1 < kept.size(); ++i) {
    const auto x = static_cast<double>(kept[i].x + kept[i + 1].x) / 2;
    const auto y = static_cast<double>(kept[i].y + kept[i + 1].y) / 2;
    EXPECT_GE(std::hypot(x, y), 3000 - 2);
  }
}

TEST(SvgPath, NumbersAreShort) {
  EXPECT_EQ(short_numbers("1.04,2 -3,.55 4,5 -0.04"), "1 2-3 .6 4 5 0");
  EXPECT_EQ(short_numbers("1 none"), "1 none");
}

TEST(Xml, ReadsAPictureAndWritesItAgain) {
  const auto node = parse_xml(
      "<?xml version='1.0'?><!DOCTYPE svg>\n<svg a=\"1 'x'\">\n <!-- no --> <g b='2'/>\n<t> "
      "a&lt;b</t></svg>\n");
  ASSERT_TRUE(node.has_value());
  EXPECT_EQ(xml_text(*node), "<svg a=\"1 'x'\"> <g b='2'/><t> a&lt;b</t></svg>");
}

TEST(Xml, RefusesWhatIsNotClosed) {
  for (const char* text :
       {"", "plain", "<a>", "<a><b></a>", "<a b=1/>", "<a b='1/>", "<a></a><b></b>"}) {
    EXPECT_FALSE(parse_xml(text).has_value()) << text;
  }
}

TEST(CompactSvg, LeavesOutWhatIsNotSeen) {
  EXPECT_EQ(
      compact_svg("<svg><title>Gnuplot</title><desc>Produced by GNUPLOT</desc>\n"
                  "<g fill=\"none\" stroke-linecap=\"butt\" stroke-linejoin=\"miter\">\n</g>\n<g "
                  "fill=\"none\" stroke-linecap=\"butt\" stroke-linejoin=\"miter\"><path d=\"M1 "
                  "2L3,5\"/><path d=\"M7 8\"/></g></svg>"),
      "<svg><g fill='none'><path d='M1 2l2 3'/></g></svg>");
}

TEST(CompactSvg, KeepsHowLinesEndWhereSomeEndOtherwise) {
  const std::string svg =
      "<svg><g stroke-linecap='round'><g stroke-linecap='butt'><b/></g></g></svg>";
  EXPECT_EQ(compact_svg(svg), svg);
}

TEST(CompactSvg, WritesColoursInSevenCharacters) {
  EXPECT_EQ(compact_svg(
                "<svg a='rgb(  0, 114, 178)' b='rgb(255,0,9)' c='rgb(256,0,0)' d='rgb(1,2,3) x'/>"),
            "<svg a='#0072b2' b='#ff0009' c='rgb(256,0,0)' d='rgb(1,2,3) x'/>");
}

TEST(CompactSvg, KeepsEveryMark) {
  EXPECT_EQ(compact_svg("<svg><path d='M0,0 L1,0 L2,0' style='stroke:none;marker:url(#m)'/></svg>"),
            "<svg><path d='M0 0l1 0 1 0' style='stroke:none;marker:url(#m)'/></svg>");
  EXPECT_EQ(compact_svg("<svg><path d='M0,0 L1,0 L2,0'/></svg>"),
            "<svg><path d='M0 0l2 0'/></svg>");
}

TEST(CompactSvg, DoesNotRoundWhatIsDefinedToBeScaled) {
  const std::string svg = "<svg><defs><path d='M0,-1.33 L-1.33,0.67 z'/></defs></svg>";
  EXPECT_EQ(compact_svg(svg), svg);
}

TEST(CompactSvg, LeavesOutLabelsWithoutText) {
  EXPECT_EQ(compact_svg("<svg><g transform='translate(1,2)'><text><tspan/></text></g><path d='M518 "
                        "359.3'/></svg>"),
            "<svg/>");
}

TEST(CompactSvg, SaysTheFontOnce) {
  EXPECT_EQ(compact_svg(
                "<svg><g font-family='A'><text><tspan font-family='A'>1</tspan></text></g></svg>"),
            "<svg font-family='A'><text>1</text></svg>");
  const std::string two =
      "<svg><g font-family='A'><text>1</text></g><g font-family='B'><text>2</text></g></svg>";
  EXPECT_EQ(compact_svg(two), two);
}

TEST(CompactSvg, WhatAllGroupsSayStandsAroundThem) {
  EXPECT_EQ(compact_svg("<svg><g id='gnuplot_canvas'><rect fill='#ffffff'/>"
                        "<g fill='none' stroke='red'><a/></g><g fill='none' "
                        "stroke='red'><b/></g><g fill='none' stroke='blue'><c/></g></g></svg>"),
            "<svg><g id='gnuplot_canvas'><rect fill='#ffffff'/><g fill='none' "
            "stroke='red'><a/><b/><g stroke='blue'><c/></g></g></g></svg>");
}

TEST(CompactSvg, JoinsGroupsThatRepeatTheOneBefore) {
  EXPECT_EQ(
      compact_svg("<svg><g id='gnuplot_plot_1'><title>gnuplot_plot_1</title><g a='1'><b/></g></g>"
                  "<g a='1'><c/></g><g a='2'><d/></g></svg>"),
      "<svg><g a='1'><b/><c/></g><g a='2'><d/></g></svg>");
}

TEST(CompactSvg, KeepsGroupsApartThatAreSeenThrough) {
  const std::string svg = "<svg><g opacity='.5'><b/></g><g opacity='.5'><c/></g></svg>";
  EXPECT_EQ(compact_svg(svg), svg);
}

TEST(CompactSvg, KeepsTextsAsTheyAre) {
  EXPECT_EQ(compact_svg("<svg>\n<text><tspan> 10  &lt;k&gt;</tspan></text>\n</svg>"),
            "<svg><text> 10  &lt;k&gt;</text></svg>");
}

TEST(CompactSvg, ReturnsWhatIsNoPictureAsItIs) {
  EXPECT_EQ(compact_svg("<svg><g></svg>"), "<svg><g></svg>");
  EXPECT_EQ(compact_svg("no picture"), "no picture");
}

}  // namespace
}  // namespace piae::page
