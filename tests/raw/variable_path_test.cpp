#include "raw/variable_path.hpp"

#include <gtest/gtest.h>

namespace piae::raw {
namespace {

/// Returns the steps as a list: "K", "Y#2", "Y[Name=a.b]", "row 2".
std::string described(const std::string& text) {
  const auto path = parse_variable(text);
  if (!path) return "none";
  std::string all;
  for (const PathStep& step : path->steps) {
    all += (all.empty() ? "" : " ") + step.name;
    if (step.number > 0) all += '#' + std::to_string(step.number);
    if (step.column > 0) all += ',' + std::to_string(step.column);
    if (!step.key.empty()) all += '[' + step.key + '=' + step.value + ']';
  }
  if (path->line) {
    all +=
        std::string(path->line->is_row ? " row " : " column ") + std::to_string(path->line->number);
  }
  return all;
}

TEST(VariablePath, HasFieldsElementsAndALine) {
  EXPECT_EQ(described("X097_DE_time"), "X097_DE_time");
  EXPECT_EQ(described("bearing.gs"), "bearing gs");
  EXPECT_EQ(described("N15_M07.Y(2).Data"), "N15_M07 Y#2 Data");
  EXPECT_EQ(described("N15.Y[Name=vibration_1].Data"), "N15 Y[Name=vibration_1] Data");
  EXPECT_EQ(described("Y[Name=1.5 kN (x)].Data"), "Y[Name=1.5 kN (x)] Data");
  EXPECT_EQ(described("c{3}"), "c#3");
  EXPECT_EQ(described("c{3,1}"), "c#3,1");
  EXPECT_EQ(described("Y(2,3).Data"), "Y#2,3 Data");
  EXPECT_EQ(described("data(2,:)"), "data row 2");
  EXPECT_EQ(described("s.data(:,12)"), "s data column 12");
  EXPECT_EQ(described("data(2, :)"), "data row 2");
  EXPECT_EQ(described("data( : , 12 )"), "data column 12");
  EXPECT_EQ(described("Y( 2, 3 ).Data"), "Y#2,3 Data");
  EXPECT_EQ(described("c{ 3 }"), "c#3");
}

TEST(VariablePath, RefusesOtherTexts) {
  for (const char* text :
       {"",        ".x",       "x.",     "x..y",     "x(0)",      "x(a)",   "x(-1)",
        "x[Name]", "x[=a]",    "x(1",    "x(1)(2)",  "x[a=b](1)", "x(0,:)", "x(:,0)",
        "x(:,:)",  "x(2,0)",   "x(0,3)", "x(2,3,4)", "x(1 2)",    "x( )",   "x(1 2,:)",
        "x(1:3)",  "x(end,:)", "x[0]",   "x[0,:]",   "(2,:)"}) {
    EXPECT_EQ(described(text), "none") << text;
  }
}

}  // namespace
}  // namespace piae::raw
