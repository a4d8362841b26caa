#include "page/compact_svg.hpp"

#include <gmock/gmock.h>

#include "page/xml.hpp"

namespace piae::page {
namespace {

using testing::HasSubstr;

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
                  "<g fill=\"none\" stroke-linecap=\"butt\" stroke-linejoin=\"miter\">\n</g>\n"
                  "<g fill=\"none\" stroke-linecap=\"butt\" stroke-linejoin=\"miter\">"
                  "<path d=\"M1 2\"/></g></svg>"),
      "<svg><g fill='none'><path d='M1 2'/></g></svg>");
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
  EXPECT_THAT(compact_svg("<svg>\n<text><tspan> 10  &lt;k&gt;</tspan></text>\n</svg>"),
              HasSubstr("<tspan> 10  &lt;k&gt;</tspan>"));
}

TEST(CompactSvg, ReturnsWhatIsNoPictureAsItIs) {
  EXPECT_EQ(compact_svg("<svg><g></svg>"), "<svg><g></svg>");
  EXPECT_EQ(compact_svg("no picture"), "no picture");
}

}  // namespace
}  // namespace piae::page
