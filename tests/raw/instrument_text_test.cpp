#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "raw/file.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

/// Text as instruments, loggers and other programs write it.
namespace piae::raw {
namespace {

using testing::ElementsAre;

class InstrumentText : public testing::Test {
 protected:
  void expect_read(const std::string& text, const std::string& column) const {
    SCOPED_TRACE(text);
    EXPECT_THAT(read_here(folder_.write("a.txt", text), column), ElementsAre(-0.5, 1.25, 2));
  }
  void expect_refused(const std::string& text, const std::string& column,
                      const std::string& why) const {
    EXPECT_ERROR(read_here(folder_.write("a.txt", text), column), Exit::bad_input, "a.txt" + why);
  }

  Folder folder_;
};

TEST_F(InstrumentText, MayHaveAPlusBeforeItsNumbers) {
  expect_read("-0.5\n+1.25\n+2\n", "1");
  expect_refused("-0.5\n+-1.25\n", "1", ", line 2: column 1 holds '+-1.25', not a number");
  expect_refused("-0.5\n+\n", "1", ", line 2: column 1 holds '+', not a number");
}

TEST_F(InstrumentText, MayEndWithWhatEditorsAndLoggersLeaveThere) {
  const std::string table = "0,-0.5\n1,1.25\n2,2";
  for (const std::string& end : {std::string("\n"), std::string("\n  \n\n"), std::string("\n\x1a"),
                                 std::string("\n\0\0\0", 4), std::string("\n \t\r\n\0\x1a", 7)}) {
    expect_read(table + end, "2");
  }
}

TEST_F(InstrumentText, MayEndItsLinesInAnyWay) {
  for (const std::string end : {"\n", "\r\n", "\r\r\n", "\r"}) {
    expect_read("t,x" + end + "0,-0.5" + end + "1,1.25" + end + "2,2" + end, "x");
  }
}

TEST_F(InstrumentText, MayHaveASeparatorAtTheEndOfItsLines) {
  expect_read("t,x\n0,-0.5,\n1,1.25,\n2,2,\n", "x");
  expect_read("t;x\n0;-0.5;\n1;1.25;\n2;2;\n", "2");
  expect_refused("t,x\n0,-0.5,7\n", "x", ", line 2: has 3 fields, the lines before 2");
}

TEST_F(InstrumentText, MayBeSeparatedByBars) {
  expect_read("t|x\n0|-0.5\n1|1.25\n2|2\n", "x");
  expect_read("0|-0.5\n1|1.25\n2|2\n", "2");
}

TEST_F(InstrumentText, MayHaveCommasInQuotedNames) {
  expect_read("\"time, s\",\"acc, g\"\n0,-0.5\n1,1.25\n2,2\n", "acc, g");
  expect_read("\"time, s\",\"acc, g\"\n0,-0.5\n1,1.25\n2,2\n", "2");
}

TEST_F(InstrumentText, MayBeginWithDatesAndUnits) {
  expect_read(
      "HBM_CATMANEASYDATAFILE 5.0\n24.02.2024 10:00:00\n\nMessrate: 12000 "
      "Hz\nZeit\tBeschl\ns\tm/s2\n\n"
      "0,0\t-0,5\t\n0,1\t1,25\t\n0,2\t2,0\t\n",
      "2");
}

TEST_F(InstrumentText, HasNoSamplesAboveItsTable) {
  const std::string table = "0.000,-0.5\n0.001,1.25\n0.002,2\n";
  expect_read("Sample rate,12000\nSensitivity,100\n" + table, "2");
  std::string decimals;
  for (int i = 0; i < 12; ++i) decimals += "0.25\n";
  expect_refused("2\n12000\n24000\n" + decimals, "1",
                 ", line 1: column 1 holds '2', a whole number above numbers with 2 decimals");
  // Where numbers are written as short as they go, a whole one is a sample.
  EXPECT_EQ(read_here(folder_.write("a.txt", "0\n0.125\n" + decimals), "1").size(), 14U);
}

TEST_F(InstrumentText, OfWholeNumbersMayHaveLeadingZerosBelowAHeader) {
  EXPECT_THAT(read_here(folder_.write("a.csv", "x,y\n0,1\n9,-0\n-8,02053\n"), "y"),
              ElementsAre(1, 0, 2053));
  expect_refused("0,5\n1,05\n", "2",
                 ", line 2: column 2 holds '05'");  // 0.5 and 1.05, or four numbers
}

TEST_F(InstrumentText, OfOneRowIsRefused) {
  std::string row = "0.5";
  for (int i = 0; i < 200; ++i) row += ",0.5";
  expect_refused(row + '\n', "1", ", line 1: is the only one and has 201 fields");
}

}  // namespace
}  // namespace piae::raw
