// Whether the colours of pages and figures can be read and told apart. The formulas are those of
// WCAG 2.1 (contrast), CIE 1976 (distance), and of Viénot, Brettel and Mollon 1999 and Brettel,
// Viénot and Mollon 1997 (colour blindness), with the matrices of DaltonLens for linear sRGB.

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <map>
#include <regex>

#include "support/folder.hpp"

namespace piae::page {
namespace {

using Colour = std::array<double, 3>;  // linear red, green and blue in [0, 1]
using Matrix = std::array<Colour, 3>;
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

Colour times(const Matrix& matrix, const Colour& colour) {
  Colour result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = std::clamp(product(matrix[i], colour), 0.0, 1.0);
  return result;
}

Colour as_protanope(const Colour& colour) {
  return times({{{0.11238, 0.88762, 0}, {0.11238, 0.88762, 0}, {0.00401, -0.00401, 1}}}, colour);
}

Colour as_deuteranope(const Colour& colour) {
  return times({{{0.29275, 0.70725, 0}, {0.29275, 0.70725, 0}, {-0.02234, 0.02234, 1}}}, colour);
}

Colour as_tritanope(const Colour& colour) {
  constexpr Matrix one_side{
      {{1.01277, 0.13548, -0.14826}, {-0.01243, 0.86812, 0.14431}, {0.07589, 0.80500, 0.11911}}};
  constexpr Matrix other_side{
      {{0.93678, 0.18979, -0.12657}, {0.06154, 0.81526, 0.12320}, {-0.37562, 1.12767, 0.24796}}};
  const bool is_one = product({0.03901, -0.02788, -0.01113}, colour) >= 0;
  return times(is_one ? one_side : other_side, colour);
}

Colour as_most_do(const Colour& colour) { return colour; }

/// CIELAB for white D65.
std::array<double, 3> lab(const Colour& colour) {
  const auto root = [](double t) {
    return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
  };
  const double x = root(product({0.4124564, 0.3575761, 0.1804375}, colour) / 0.95047);
  const double y = root(product({0.2126729, 0.7151522, 0.0721750}, colour));
  const double z = root(product({0.0193339, 0.1191920, 0.9503041}, colour) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double distance(const Colour& a, const Colour& b) {
  const auto p = lab(a);
  const auto q = lab(b);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

/// The colours that a block of style.css names, after a text that comes before the block.
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

TEST_P(Scheme, EveryTextCanBeReadOnItsGround) {
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

TEST_P(Scheme, BarsStandOutOfTheGround) {
  for (const char* bar : {"bar", "bar-bad"}) {
    EXPECT_GE(contrast(palette_.at(bar), palette_.at("ground")), 3) << bar;
  }
}

struct Sight {
  const char* name;
  Colour (*seen)(const Colour&);
};
constexpr Sight sights[] = {{"usual", as_most_do},
                            {"without red", as_protanope},
                            {"without green", as_deuteranope},
                            {"without blue", as_tritanope}};

/// What two colours must differ by: four times what is just noticed (2.3).
constexpr double least_distance = 9.2;

void expect_told_apart(const Palette& colours) {
  for (const Sight& sight : sights) {
    for (auto a = colours.begin(); a != colours.end(); ++a) {
      for (auto b = std::next(a); b != colours.end(); ++b) {
        EXPECT_GE(distance(sight.seen(a->second), sight.seen(b->second)), least_distance)
            << a->first << " and " << b->first << ", " << sight.name;
      }
    }
  }
}

TEST_P(Scheme, WhatIsGoodBadAndNeitherIsToldApart) {
  expect_told_apart({{"good", palette_.at("good")},
                     {"bad", palette_.at("bad")},
                     {"neutral", palette_.at("neutral")}});
  expect_told_apart({{"bar", palette_.at("bar")}, {"bar-bad", palette_.at("bar-bad")}});
}

TEST_P(Scheme, EachLowShadeIsStrongerThanTheOneBefore) {
  const char* shades[] = {"ground", "low-1", "low-2", "low-3", "low-4"};
  for (std::size_t i = 0; i + 1 < std::size(shades); ++i) {
    EXPECT_GT(contrast(palette_.at(shades[i + 1]), palette_.at("ground")),
              contrast(palette_.at(shades[i]), palette_.at("ground")) + 0.05)
        << shades[i + 1];
  }
}

TEST(Palette, TheSeriesOfFiguresAreToldApartByAnyEye) {
  const std::string style = bytes_of(source_folder + "/pipeline/figures/style.gp");
  const std::size_t begin = style.find("array okabe_ito[8] = [");
  ASSERT_NE(begin, std::string::npos);
  const std::string list =
      style.substr(begin, style.find(']', style.find('[', begin + 20)) - begin);
  const std::regex hexadecimal("0x([0-9A-F]{6})");
  Palette colours;
  for (std::sregex_iterator match(list.begin(), list.end(), hexadecimal), end; match != end;
       ++match) {
    colours[(*match)[1]] = colour_of((*match)[1]);
  }
  ASSERT_EQ(colours.size(), 8U);
  expect_told_apart(colours);
}

TEST(Palette, TheFormulasGiveWhatIsKnown) {
  const Colour white = colour_of("ffffff");
  EXPECT_NEAR(contrast(colour_of("000000"), white), 21, 1e-9);
  EXPECT_NEAR(contrast(colour_of("777777"), white), 4.48, 0.005);  // WCAG's own example
  EXPECT_NEAR(lab(colour_of("ff0000"))[0], 53.24, 0.01);
  EXPECT_NEAR(lab(colour_of("ff0000"))[1], 80.09, 0.01);
  for (const Sight& sight : sights)
    EXPECT_NEAR(luminance(sight.seen(white)), 1, 1e-3) << sight.name;
}

}  // namespace
}  // namespace piae::page
