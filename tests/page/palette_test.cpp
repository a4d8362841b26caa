// Contrast of the colours of pages by WCAG 2.1. The colours of series are from Okabe and Ito
// (2008), who chose them to remain distinct with the usual colour blindnesses.

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <map>
#include <regex>

#include "support/folder.hpp"

namespace piae::page {
namespace {

using Colour = std::array<double, 3>;  // linear red, green and blue in [0, 1]
using Palette = std::map<std::string, Colour>;

const std::string source_folder = PIAE_SOURCE;

double linear(int byte) {
  const double value = byte / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

Colour colour_of(const std::string& six_digits) {
  const int rgb = std::stoi(six_digits, nullptr, 16);
  return {linear(rgb >> 16 & 255), linear(rgb >> 8 & 255), linear(rgb & 255)};
}

double product(const Colour& a, const Colour& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double luminance(const Colour& colour) { return product({0.2126, 0.7152, 0.0722}, colour); }

double contrast(const Colour& a, const Colour& b) {
  const auto [dark, light] = std::minmax({luminance(a), luminance(b)});
  return (light + 0.05) / (dark + 0.05);
}

/// Returns the colours of the block of style.css that follows `text`.
Palette palette_after(const std::string& text) {
  const std::string css = bytes_of(source_folder + "/pipeline/report/style.css");
  const std::size_t begin = css.find(text);
  EXPECT_NE(begin, std::string::npos) << text;
  const std::string block = css.substr(begin, css.find("}", begin) - begin);
  const std::regex named("--([a-z0-9-]+): #([0-9a-f]{6});");
  Palette palette;
  for (std::sregex_iterator match(block.begin(), block.end(), named), end; match != end; ++match) {
    palette[(*match)[1]] = colour_of((*match)[2]);
  }
  return palette;
}

class Scheme : public testing::TestWithParam<const char*> {
 protected:
  const Palette palette_ = palette_after(GetParam());
};

INSTANTIATE_TEST_SUITE_P(Palette, Scheme,
                         testing::Values(":root {", "(prefers-color-scheme: dark)",
                                         "@media print"));

TEST_P(Scheme, HasReadableTextOnEveryBackground) {
  const std::multimap<std::string, std::string> pairs{
      {"text", "ground"},      {"text", "panel"},    {"text", "bad-ground"},
      {"text", "low-1"},       {"text", "low-2"},    {"text", "low-3"},
      {"text", "low-4"},       {"quiet", "ground"},  {"quiet", "panel"},
      {"quiet", "bad-ground"}, {"link", "ground"},   {"link", "panel"},
      {"link", "bad-ground"},  {"good", "ground"},   {"bad", "ground"},
      {"bad", "bad-ground"},   {"neutral", "ground"}};
  for (const auto& [text, ground] : pairs) {
    EXPECT_GE(contrast(palette_.at(text), palette_.at(ground)), 4.5) << text << " on " << ground;
  }
}

TEST_P(Scheme, HasBarsThatStandOut) {
  for (const char* bar : {"bar", "bar-bad"}) {
    EXPECT_GE(contrast(palette_.at(bar), palette_.at("ground")), 3) << bar;
  }
}

TEST_P(Scheme, HasIncreasinglyStrongShades) {
  const char* shades[] = {"ground", "low-1", "low-2", "low-3", "low-4"};
  for (std::size_t i = 0; i + 1 < std::size(shades); ++i) {
    EXPECT_GT(contrast(palette_.at(shades[i + 1]), palette_.at("ground")),
              contrast(palette_.at(shades[i]), palette_.at("ground")) + 0.05)
        << shades[i + 1];
  }
}

TEST(Palette, MatchesKnownContrasts) {
  const Colour white = colour_of("ffffff");
  EXPECT_NEAR(contrast(colour_of("000000"), white), 21, 1e-9);
  EXPECT_NEAR(contrast(colour_of("777777"), white), 4.48, 0.005);  // WCAG's own example
}

}  // namespace
}  // namespace piae::page
