#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "raw/file.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

/// Text in the formats of instruments, loggers and other programs.
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
    EXPECT_ERROR(read_here(folder_.write("a.txt", text), column), Exit::bad_input, why);
    EXPECT_ERROR(read_here(folder_ / "a.txt", column), Exit::bad_input, "a.txt, line ");
  }

  Folder folder_;
};

TEST_F(InstrumentText, MayHaveAPlusBeforeItsNumbers) {
  expect_read("-0.5\n+1.25\n+2\n", "1");
  expect_refused("-0.5\n+-1.25\n", "1", ", line 2: column 1 holds '+-1.25', not a number");
  expect_refused("-0.5\n+\n", "1", ", line 2: column 1 holds '+', not a number");
}

TEST_F(InstrumentText, MayEndWithNullsCtrlZOrBlankLines) {
  const std::string table = "0,-0.5\n1,1.25\n2,2";
  for (const std::string& end : {std::string("\n"), std::string("\n  \n\n"), std::string("\n\x1a"),
                                 std::string("\n\0\0\0", 4), std::string("\n \t\r\n\0\x1a", 7)}) {
    expect_read(table + end, "2");
  }
}

TEST_F(InstrumentText, MayEndItsLinesInAnyWay) {
  for (const std::string end : {"\n", "\r\n", "\r\r\n", "\r"}) {
    const std::string text = "t,x" + end + "0,-0.5" + end + "1,1.25" + end + "2,2" + end;
    for (const char* last : {"", "\n", "\r\n", "\r\n \x1a"}) expect_read(text + last, "x");
  }
}

TEST_F(InstrumentText, MayHaveASeparatorAtTheEndOfItsLines) {
  expect_read("t,x\n0,-0.5,\n1,1.25,\n2,2,\n", "x");
  expect_read("t;x\n0;-0.5;\n1;1.25;\n2;2;\n", "2");
  expect_refused("t,x\n1,2\n0,-0.5,7\n", "x", ", line 3: has 3 fields, the lines above have 2");
  // Trailing separators of a header do not name a column.
  expect_read("t,x,,\n0,-0.5\n1,1.25\n2,2\n", "x");
}

TEST_F(InstrumentText, MayBeSeparatedByBars) {
  expect_read("t|x\n0|-0.5\n1|1.25\n2|2\n", "x");
  expect_read("0|-0.5\n1|1.25\n2|2\n", "2");
}

TEST_F(InstrumentText, MayHaveCommasInQuotedNames) {
  expect_read("\"time, s\",\"acc, g\"\n0,-0.5\n1,1.25\n2,2\n", "acc, g");
  expect_read("\"time, s\",\"acc, g\"\n0,-0.5\n1,1.25\n2,2\n", "2");
}

TEST_F(InstrumentText, MayStartWithDatesAndUnits) {
  expect_read(
      "HBM_CATMANEASYDATAFILE 5.0\n24.02.2024 10:00:00\n\nMessrate: 12000 "
      "Hz\nZeit\tBeschl\ns\tm/s2\n\n"
      "0,0\t-0,5\t\n0,1\t1,25\t\n0,2\t2,0\t\n",
      "2");
}

TEST_F(InstrumentText, MayHaveSeveralLinesOfWordsBelowTheNames) {
  for (const char* words :
       {"s,g\nraw,raw\n", "s,m/s^2\nSensor 1,Sensor 2\n", "s,10 mV\n", "s,100 mV/g\n,CH2\n",
        "s,(m/s2)\n# calibrated\nraw,16bit ADC\n", "-,-\nraw,raw\na,b\n"}) {
    expect_read("Time,Acc\n" + std::string(words) + "0,-0.5\n1,1.25\n2,2\n", "Acc");
  }
  // Dashes may be missing samples.
  expect_refused("Acc\n-\n-\n0.5\n", "Acc", ", line 2: column Acc holds '-', not a number");
  // A damaged number does not count as a word, also with others in its line.
  for (const char* line : {"0,q.25", "0,q2345", "0,1.25x", "0,1.q5e+00", "s,1.2.5", "0,g"}) {
    expect_refused("Time,Acc\n" + std::string(line) + "\n0,-0.5\n1,1.25\n", "Acc",
                   ", line 2: column Acc holds '" + std::string(line + 2) +
                       "', not a number; if this line belongs to the header, name the column by "
                       "its number");
  }
}

TEST_F(InstrumentText, MayStartWithMissingSamplesBelowTheNames) {
  for (const char* row : {"NaN,NaN\n", "nan,-nan(ind)\n", "nan,-inf\n", "Inf,+Inf\n"}) {
    std::string text = "t,x\n";
    for (int i = 0; i < 190; ++i) text += row;
    for (int i = 0; i < 20; ++i) text += "0.1,-0.5\n0.2,1.25\n";
    const auto file = folder_.write("a.txt", text);
    for (const char* column : {"1", "t", "2", "x"}) {
      EXPECT_EQ(read_here(file, column).size(), 230U) << row << column;
    }
  }
}

TEST_F(InstrumentText, IsRefusedWithWordsInThePlaceOfItsFirstSamples) {
  const std::string table = "0,-0.5\n1,1.25\n2,2\n";
  for (const std::string word : {"OVL", "Over", "overload", "OL", "N/A", "NA"}) {
    for (const int count : {1, 3, 9}) {
      std::string rows = "t,x\n";
      for (int i = 0; i < count; ++i) rows.append(word).append(",").append(word).append("\n");
      expect_refused(rows + table, "x", ", line 2: column x holds '" + word + "', not a number");
      expect_refused(rows + table, "2",
                     ", line 2: column 2 holds '" + word + "', neither a number");
    }
  }
  // Units and channels have a few lines.
  std::string words = "t,x\n";
  for (int i = 0; i < 5; ++i) words += "s,g\n";
  expect_read(words + table, "x");
  expect_refused(words + "s,g\n" + table, "x", ", line 2: column x holds 'g', not a number");
  expect_refused("t,x\nn1,-\nn2,-\n" + table, "x", ", line 2: column x holds '-', not a number");
}

TEST_F(InstrumentText, IsRefusedWithWordsOnly) {
  std::string text;
  for (int i = 0; i < 10'000; ++i) text += "a,b\n";
  for (const char* column : {"a", "1"}) {
    expect_refused(text, column, ", line 10000: no numbers begin up to this line");
  }
  expect_refused("a,b\na,b\n", "a", ", line 2: column a holds 'a', not a number");
}

TEST_F(InstrumentText, MayHaveManyLinesAboveTheTable) {
  const std::string rows = "0,-0.5\n1,1.25\n2,2\n";
  for (const char* note : {"# Note 12: set up\n", "Note 12: set up\n", "Rate,12000\n", "\n"}) {
    std::string notes;
    for (int i = 0; i < 3000; ++i) notes += note;
    expect_read(notes + rows, "2");
    expect_read(notes + "t,x\n" + rows, "x");
  }
  // Rows of numbers may stand among the lines.
  std::string many_notes = "Serial,Model\n123,456\n";
  for (int i = 0; i < 300; ++i) many_notes += "Note: set up\n";
  expect_read("Info\n5000\n" + many_notes + "t,x\n" + rows, "x");
  std::string text;
  for (int i = 0; i < 10'000; ++i) text += "# Note 12: set up\n";
  expect_refused(
      text + rows, "2",
      ", line 10000: no numbers begin up to this line; remove the lines above the table");
}

TEST_F(InstrumentText, NeverTakesSamplesFromAboveTheTable) {
  const std::string table = "0.000,-0.5\n0.001,1.25\n0.002,2\n";
  expect_read("Sample rate,12000\nSensitivity,100\n" + table, "2");
  std::string decimals;
  for (int i = 0; i < 12; ++i) decimals += "0.25\n";
  expect_refused("2\n12000\n24000\n" + decimals, "1",
                 ", line 1: column 1 holds '2', in another format than the numbers below");
  // If other numbers show that trailing zeros are dropped, an integer is a sample.
  EXPECT_EQ(read_here(folder_.write("a.txt", "0\n0.125\n" + decimals + "1\n"), "1").size(), 15U);
}

/// Returns twenty samples of several digits, one a line after `before`; `form` is a printf format.
std::string samples(const std::string& before = "", const char* form = "%.6f") {
  std::string text;
  for (int i = 0; i < 20; ++i) {
    std::array<char, 40> number{};
    (void)std::snprintf(number.data(), number.size(), form, std::sin(1.0 + i));
    text += before + number.data() + '\n';
  }
  return text;
}

TEST_F(InstrumentText, IsRefusedWithNumbersOfAnotherFormatAboveTheTable) {
  const std::string why = ", in another format than the numbers below, such as '";
  expect_refused("0\n" + samples("", "%.15g"), "1", "line 1: column 1 holds '0'" + why);  // pandas
  expect_refused("1.0\n" + samples(), "1", "line 1: column 1 holds '1.0'" + why);
  expect_refused("12000.0\n" + samples(), "1", why);
  expect_refused("1.2E+04\n" + samples("", "%.6E"), "1", why);
  expect_refused("acc\ng\n9.81\n" + samples(), "acc", "line 3: column acc holds '9.81'" + why);
  // Times start with a plain 0. Samples in several formats may have any format.
  std::string times = "t,x\n0,0.5\n";
  for (int i = 1; i < 20; ++i) times += std::to_string(0.001 * i) + ",0.5\n";
  EXPECT_EQ(read_here(folder_.write("a.txt", times), "t").size(), 20U);
  EXPECT_EQ(read_here(folder_.write("a.txt", samples("", "%.3g") + "1\n" + samples()), "1").size(),
            41U);
}

/// Returns 300 samples in the form of printf, one in each line after `before`.
std::string many_samples(const std::string& before = "", const char* form = "%.6f") {
  std::string text;
  for (int i = 0; i < 300; ++i) {
    std::array<char, 40> number{};
    (void)std::snprintf(number.data(), number.size(), form, 3 * std::sin(1.0 + i));
    text += before + number.data() + '\n';
  }
  return text;
}

/// A count of samples, a rate or a sum may follow the samples, or stand between two blocks of them.
TEST_F(InstrumentText, IsRefusedWithAWholeNumberAmongFixedDecimals) {
  const std::string why = ", a whole number among numbers with decimals; it seems not to be a";
  for (const char* form : {"%.6f", "%.2f", "%+.4f", "%.6E"}) {
    SCOPED_TRACE(form);
    const std::string table = many_samples("", form);
    expect_refused(table + "3000\n", "1", "line 301: column 1 holds '3000'" + why);
    expect_refused(table + "-3000\n", "1", "line 301: column 1 holds '-3000'" + why);
    expect_refused(table + "12000\n" + table, "1", "line 301: column 1 holds '12000'" + why);
    expect_refused(table + "12000\n600\n" + table, "1", "line 301: column 1 holds '12000'" + why);
  }
  const std::string times = "t,x\n" + many_samples("0.001,");
  expect_refused(times + "0,3000\n", "x", "line 302: column x holds '3000'" + why);
}

TEST_F(InstrumentText, MayHaveWholeNumbersAmongOtherForms) {
  const auto count = [&](const std::string& text) {
    return read_here(folder_.write("a.txt", text), "1").size();
  };
  // Programs that drop zeros at the end write fewer decimals from time to time.
  EXPECT_EQ(count(many_samples("", "%.6g") + "3\n" + many_samples("", "%.6g")), 601U);
  EXPECT_EQ(count(many_samples("", "%.1f") + "3\n" + many_samples("", "%.1f")), 601U);
  EXPECT_EQ(count(many_samples() + "2.5\n3\n" + many_samples()), 602U);
  // Two levels: zeros at the end may have been dropped.
  std::string levels;
  for (int i = 0; i < 300; ++i) levels += i % 2 == 0 ? "0.02\n" : "-0.25\n";
  EXPECT_EQ(count(levels + "5\n" + levels), 601U);
  EXPECT_EQ(count(levels + "5\n" + levels + "NaN"), 602U);
  expect_refused(levels + "0.50\n5\n", "1", "line 302: column 1 holds '5', a whole number");
  // MATLAB prints an exact zero as 0. Overflows and missing values have no decimals.
  EXPECT_EQ(count(many_samples() + "0\n-0\nNaN\nInf\n" + many_samples()), 604U);
  // Too many, or too few other samples.
  std::string whole;
  for (int i = 0; i < 20; ++i) whole += "3\n";
  EXPECT_EQ(count(many_samples() + whole), 320U);
  EXPECT_EQ(count(samples() + "3\n"), 21U);
}

/// A text cut anywhere within its last number still ends in a number.
TEST_F(InstrumentText, IsRefusedIfCutWithinItsLastNumber) {
  const std::string why = "', with fewer digits than all others and no line end";
  for (const char* form : {"%.6f", "%.1f", "%.6E"}) {
    for (const char* before : {"", "0.001,"}) {
      const std::string table = many_samples(before, form);
      const std::string column = *before == '\0' ? "1" : "2";
      EXPECT_EQ(read_here(folder_.write("a.txt", table), column).size(), 300U);
      // The number may be complete.
      EXPECT_EQ(read_here(folder_.write("a.txt", table.substr(0, table.size() - 1)), column).size(),
                300U);
      const std::size_t number = table.rfind(*before == '\0' ? '\n' : ',', table.size() - 2) + 1;
      for (std::size_t size = table.size() - 2; size > number; --size) {
        SCOPED_TRACE(table.substr(number, size - number));
        expect_refused(table.substr(0, size), column, "a.txt, line 300: ");
      }
    }
  }
  const std::string table = many_samples();
  expect_refused(table.substr(0, table.size() - 3), "1", why);
  expect_refused(table.substr(0, table.size() - 3) + std::string(8, '\0'), "1", why);
  // Whole lines are complete.
  EXPECT_EQ(read_here(folder_.write("a.txt", table + "0.5\n"), "1").size(), 301U);
  // Another column is complete.
  EXPECT_EQ(read_here(folder_.write("b.txt", many_samples("0.001,") + "0.001,0.12"), "1").size(),
            301U);
}

TEST_F(InstrumentText, MayStartWithZerosBelowItsName) {
  // MATLAB's writetable and %.15g write 0 without decimals.
  for (const char* zeros : {"0\n", "0\n0\n0\n", "0\n-0\n"}) {
    for (const char* form : {"%.6f", "%.15g"}) {
      const auto lines = static_cast<std::size_t>(std::ranges::count(std::string(zeros), '\n'));
      const std::string text = zeros + samples("", form);
      EXPECT_EQ(read_here(folder_.write("a.txt", "acc\n" + text), "acc").size(), lines + 20);
      EXPECT_EQ(read_here(folder_.write("a.txt", "acc [g]\n" + text), "1").size(), lines + 20);
    }
  }
  // Between samples, too.
  for (const auto& [first, form] : {std::pair("0.5000", "%.4f"), std::pair("5.0000e-01", "%.4e")}) {
    const std::string text = first + std::string("\n0\n") + samples("", form);
    EXPECT_EQ(read_here(folder_.write("a.txt", "acc\n" + text), "acc").size(), 22U);
    EXPECT_EQ(read_here(folder_.write("a.txt", text), "1").size(), 22U);
  }
  const std::string why = ", in another format than the numbers below, such as '";
  expect_refused("acc\n0\n12000\n" + samples(), "acc", "line 2: column acc holds '0'" + why);
  expect_refused("t,0\n0,0\n" + samples("0,"), "2", "line 2: column 2 holds '0'" + why);
}

TEST_F(InstrumentText, IsRefusedWithWordsAmongNumbers) {
  const std::string why = "', where other lines have a number; if another table begins here";
  const std::string table = samples("0.1,");
  expect_refused("t,x\n" + table + "Sample rate,12000\n" + table, "x",
                 "line 22: begins with 'Sample rate" + why);
  expect_refused("t,x\n" + table + "Max,3.2\n", "x", "line 22: begins with 'Max" + why);
  expect_refused("time;acc\ns;9.810000\n" + samples("0.1;"), "acc", "line 2: begins with 's" + why);
  expect_refused("Start 2026-11-27 12:00:00,100.500000\n" + samples("12:00:00.1,"), "2",
                 "line 1: begins with 'Start 2026-11-27 12:00:00" + why);
  // Row names and missing numbers belong to a table.
  EXPECT_EQ(read_here(folder_.write("a.txt", samples("n,")), "2").size(), 20U);
  EXPECT_EQ(read_here(folder_.write("a.txt", table + "nan,0.5\n" + table), "2").size(), 41U);
}

TEST_F(InstrumentText, IsRefusedWithAmbiguousCommas) {
  expect_refused("t;x\n0.1;5,121\n0.2;5,122\n", "x",
                 "line 2: holds '5,121' and '0.1', with two decimal signs");
  expect_refused("x\n2,401\n-1,233\n4,379\n", "x",
                 "line 2: holds '2,401', where the comma may precede decimals or thousands");
  expect_refused("2 037\n3 465\n1 002\n", "1", "line 1: seems to have blanks between thousands");
  expect_refused("5,114567\n5,024567\n", "1", "the numbers seem to have decimal commas");
  expect_refused("0,000000,0,345584\n0,000100,0,445584\n", "1",
                 "the numbers seem to have decimal commas");
  // One number shows the meaning of the comma.
  EXPECT_THAT(read_here(folder_.write("a.txt", "x\n2,401\n0,250\n"), "x"),
              ElementsAre(2.401, 0.25));
  EXPECT_THAT(read_here(folder_.write("a.txt", "2 437\n3 465\n"), "1"), ElementsAre(2, 3));
}

TEST_F(InstrumentText, MayHaveQuotedDecimalCommas) {
  expect_read("t,x\n\"0,000\",\"-0,5\"\n\"0,001\",\"1,25\"\n\"0,002\",2\n", "x");
  expect_read("\"0,000\",\"-0,5\"\n\"0,001\",\"1,25\"\n\"0,002\",\"2\"\n", "2");
  expect_refused("t,x\n0,\"2,401\"\n1,\"640\"\n2,\"-1,233\"\n", "x",
                 "line 2: holds '2,401', where the comma may precede decimals or thousands");
  expect_refused("t,x\n0.1,\"2,401\"\n0.2,\"0,25\"\n", "x",
                 "line 2: holds '2,401' and '0.1', with two decimal signs");
  expect_refused("t,x\n0,\"2,40\"\n0,0.25\n", "x",
                 "line 3: column x holds '0.25', but a line above has the other decimal sign");
}

TEST_F(InstrumentText, MayBeAColumnOfDecimalCommas) {
  // Whole numbers are written without a -0 before and a padded 05 behind the comma.
  const std::string ten = "1,020\n-0,500\n3,25\n-4\n5\n6\n7\n8\n9\n10,5\n";
  EXPECT_THAT(read_here(folder_.write("a.txt", ten), "1"),
              ElementsAre(1.02, -0.5, 3.25, -4, 5, 6, 7, 8, 9, 10.5));
  const std::string why = "the numbers seem to have decimal commas";
  expect_refused("1,020\n-0,500\n3,250\n", "1", why);  // too few to tell
  std::string counts;                                  // a counter and a time of day have no -0
  for (int i = 0; i < 10; ++i) counts += "5,09301" + std::to_string(i) + "\n";
  expect_refused(counts, "1", why);
}

TEST_F(InstrumentText, IsRefusedWithDecimalCommasBehindOtherColumns) {
  const std::string why = "the numbers seem to have decimal commas";
  // A counter and numbers with decimal commas: an odd number of fields.
  const std::string counted = "0,-282,227\n1,113,054\n2,-96,981\n";
  expect_refused(counted, "2", "line 2: holds 113,054: " + why);
  expect_refused(counted, "3", "line 2: holds 113,054: " + why);
  expect_refused("7,0,001,-282,227\n8,0,002,113,954\n9,0,003,-0,981\n", "4", why);
  expect_refused("0,5,25,-1\n1,-0,5,-2\n", "2", why);  // zeros at the end dropped
  expect_refused("0,4,123E-03\n1,5,12E+00\n", "2", why);
  expect_refused("0,4,1E-03\n1,-5,2E+00\n", "3", why);
  expect_refused("0,4,123 g\n1,5,025 g\n", "2", why);
  expect_refused("0,,123\n1,-,250\n", "3",
                 "line 2: holds -,250: " + why);  // no zero before the comma
  expect_refused("10:00:00,000,0.5\n10:00:00,001,0.25\n", "2",
                 "line 1: holds 10:00:00,000: " + why);
  EXPECT_THAT(read_here(folder_.write("a.csv", "10:00:00,000,0.5\n10:00:00,001,0.25\n"), "3"),
              ElementsAre(0.5, 0.25));
  // One decimal shows all ten digits.
  std::string digits;
  for (int i = 0; i < 30; ++i) digits += fmt::format("{},{},{}\n", i, 7 * i - 90, i * 7 % 10);
  expect_refused(digits, "2", why);
  expect_refused(digits, "3", why);
}

TEST_F(InstrumentText, IsRefusedWithDecimalCommasBelowTheNamesOfOtherColumns) {
  const std::string why = ": the numbers seem to have decimal commas";
  // These lines do not name three columns.
  for (const char* above :
       {"Zeit,Beschl,\n", "Rate,12000,Hz\nTime,Acc\n", "Device,Sensor,Unit\nTime,Acc\n"}) {
    expect_refused(above + std::string("0,1,037\n1,2,465\n2,-3,991\n"), "3", "holds 1,037" + why);
  }
  expect_refused("Date,Time,Acc,Alarm\n05.01.2024,10:00:00,1,037,\n05.01.2024,10:00:01,2,465,\n",
                 "Acc", "line 2: holds 1,037" + why);
  // Programs write no columns with both a -0 and a 037, whatever their names and other columns.
  expect_refused("Time,Acc,Mark\n0,1,037\n1,-0,465\n", "Acc", "line 2: holds 1,037" + why);
  expect_refused("10.00,1,037\n10.01,-0,465\n", "2", "line 1: holds 1,037" + why);
}

TEST_F(InstrumentText, MayBeWholeNumbersThatAreNotDecimals) {
  const auto read_whole = [&](const std::string& text, const std::string& column) {
    return read_here(folder_.write("a.csv", text), column);
  };
  EXPECT_THAT(read_whole("0,5,05,-1\n1,4,10,7\n", "4"), ElementsAre(-1, 7));
  EXPECT_THAT(read_whole("0,-282,-227\n1,113,54\n", "3"), ElementsAre(-227, 54));
  EXPECT_THAT(read_whole("0,-282,227,0.5\n1,113,054,0.25\n", "3"), ElementsAre(227, 54));
  EXPECT_THAT(read_whole("00001,00585,00378\n00002,00012,00403\n", "3"), ElementsAre(378, 403));
  EXPECT_THAT(read_whole("START\n10,561\n20,563\n", "2"), ElementsAre(561, 563));
  EXPECT_THAT(read_whole("x,y,z\n\"1\",543,383,384\n\"2\",540,380,381\n", "4"),
              ElementsAre(384, 381));
  std::string low;  // a converter's lowest values, next to those of another channel
  for (int i = 0; i < 30; ++i) low += fmt::format("{},{}\n", 300 + i % 7, i % 10);
  EXPECT_EQ(read_whole(low, "2").size(), 30U);
}

TEST_F(InstrumentText, IsRefusedWithFewerNamesThanFieldsOfWholeNumbers) {
  const std::string table = "0,-282,227\n1,113,354\n2,-96,981\n";
  expect_refused(
      "time,acc\n" + table, "2",
      "line 2: has 3 fields below a header of 2: the numbers seem to have decimal commas");
  expect_refused("time,acc\n" + table, "acc",
                 "line 1: is a header of 2 names above lines of 3 fields; name the column by its "
                 "number, 1 to 3, or separate the fields by semicolons if the numbers have decimal "
                 "commas");
  expect_refused("acc\n-282,227\n113,354\n", "1", "has 2 fields below a header of 1: the numbers");
  // R writes no name above the row numbers.
  EXPECT_THAT(read_here(folder_.write("a.csv", "\"t\",\"acc\"\n\"1\",0,-5\n\"2\",1,13\n"), "3"),
              ElementsAre(-5, 13));
}

/// pandas writes the numbers of columns without names.
TEST_F(InstrumentText, MayHaveColumnNumbersAsAHeader) {
  EXPECT_THAT(read_here(folder_.write("a.csv", ",0,1\n0,103,93\n1,-7,12\n"), "2"),
              ElementsAre(103, -7));
}

/// Tektronix oscilloscopes write metadata next to the first samples.
TEST_F(InstrumentText, MayHaveMetadataNextToSamples) {
  const std::string table =
      "Record Length,2.5e+03,,-0.005,0.02,\nSample Interval,4e-06,,-0.004996,0.04,\n"
      "Source,CH1,,-0.004992,0.02,\n,,,-0.004988,0.06,\n,,,-0.004984,0.08,\n";
  EXPECT_THAT(read_here(folder_.write("a.csv", table), "5"),
              ElementsAre(0.02, 0.04, 0.02, 0.06, 0.08));
}

TEST_F(InstrumentText, IsRefusedWithBlanksBetweenThousandsInEitherPart) {
  expect_refused("2 037\n3 465\n1 002\n", "2", "line 1: seems to have blanks between thousands");
}

TEST_F(InstrumentText, IsRefusedWithSeparatorsOfThousands) {
  const std::string how = "; write decimal points and no thousands separators";
  expect_refused("a;b\n0,1;1.640,337\n0,2;2.640,337\n", "2",
                 "line 2: column 2 holds '1.640,337', not a number" + how);
  expect_refused("a;b\n0,1;1.640,337\n0,2;2.640,337\n", "b",
                 "line 2: column b holds '1.640,337', not a number" + how);
  expect_refused("a,b\n0.1,\"640.5\"\n0.2,\"2,640.337\"\n", "b",
                 "line 3: column b holds '2,640.337', not a number" + how);
}

TEST_F(InstrumentText, MayHaveLeadingZerosBelowAHeader) {
  EXPECT_THAT(read_here(folder_.write("a.csv", "x,y\n0,1\n9,-0\n-8,02053\n"), "y"),
              ElementsAre(1, 0, 2053));
  expect_refused("0,5\n1,05\n", "2",
                 ", line 2: holds 1,05: the numbers");  // ambiguous: 0.5 and 1.05, or four numbers
}

TEST_F(InstrumentText, MayBeWholeNumbersWithSignsAndNoHeader) {
  // If commas were decimal signs, no sign could follow a comma.
  EXPECT_THAT(read_here(folder_.write("a.csv", "1,-0\n-0,2\n07,-3\n"), "1"), ElementsAre(1, 0, 7));
  EXPECT_THAT(read_here(folder_.write("a.csv", "007\n-0\n0100\n"), "1"), ElementsAre(7, 0, 100));
  EXPECT_THAT(read_here(folder_.write("a.csv", "0;007\n1;-0\n"), "2"), ElementsAre(7, 0));
  expect_refused("-0,5\n1,2\n", "1",
                 ", line 1: holds -0,5: the numbers seem to have decimal commas");
}

TEST_F(InstrumentText, IsRefusedAtTheStartOfASecondTable) {
  const std::string table = "t,x\n0,-0.5\n1,1.25\n";
  const std::string another = " between lines of numbers; if another table begins here, save it in";
  expect_refused(table + table, "x", ", line 4: holds 't,x'" + another);
  expect_refused(table + table, "2", ", line 4: holds 't,x'" + another);
  expect_refused(table + "t,x,force\n0,1,2\n", "x", ", line 4: holds 't,x,force'" + another);
  expect_refused(table + "\n" + table, "x", ", line 4: is blank" + another);
  expect_refused(table + "# restarted\n2,3\n", "2", ", line 4: holds '# restarted'" + another);
  expect_refused(table + "Run 2\n2,3\n", "2", ", line 4: holds 'Run 2'" + another);
  expect_refused("x\n0.5\nx\n2.5\n", "x", ", line 3: holds 'x'" + another);
  expect_refused("0.5\n1.5\nx\n2.5\n", "1", ", line 3: column 1 holds 'x', not a number");
}

/// Latin-1, and GBK, where a character may end with the byte of a bar.
TEST_F(InstrumentText, IsReadByNumberIfNotInUtf8) {
  const std::string rows = "0,-0.5\n1,1.25\n2,2\n";
  const std::string latin1 = "Zeit [s],Beschl. [m/s\xb2]\n" + rows;
  const std::string gbk = "\xca\xb1\xbc\xe4,\xbc\xd3\x95\x7c\xb6\xc8\n" + rows;
  expect_read(latin1, "2");
  expect_read(gbk, "2");
  expect_read(
      "Pr\xfc"
      "fstand 3\n" +
          latin1,
      "2");
  expect_read(
      "# \xb1"
      "5 g\nt,x\n" +
          rows,
      "x");
  const std::string why = "; the file is not in UTF-8, so name the column by its number, 1 to 2";
  expect_refused(latin1, "Beschl. [m/s²]", ", line 1: has no column Beschl. [m/s²]" + why);
  expect_refused(gbk, "加速度", ", line 1: has no column 加速度" + why);
  EXPECT_THAT(read_here(folder_.write("a.txt", latin1), "Zeit [s]"), ElementsAre(0, 1, 2));
}

TEST_F(InstrumentText, IsReadByNumberIfTheHeaderHasOtherFields) {
  const std::string rows = "0,-0.5\n1,1.25\n2,2\n";
  for (const char* header : {"x\n", "t,x,force\n", "t x [g]\n"}) {
    expect_read(header + rows, "2");
    expect_refused(header + rows, "x", " above lines of 2 fields; name the column by its number");
  }
  expect_read("t x\n1 0 -0.5\n2 1 1.25\n3 2 2\n", "3");  // R writes row names without a header
  expect_refused("t x\n1 0 -0.5\n2 1 1.25\n", "x", ", line 1: is a header of 2 names above lines");
  expect_read(",x\n" + rows, "x");  // pandas writes row numbers with an empty header
}

/// Loggers write a date or time in each row.
TEST_F(InstrumentText, MayHaveAColumnOfDatesOrTimes) {
  struct Table {
    std::string separator;
    std::vector<std::string> times;
    bool has_decimal_commas = false;
  };
  for (const auto& [separator, times, has_decimal_commas] :
       {Table{",", {"2024-01-01 12:00:00.000", "2024-01-01 12:00:00.001", "2024-01-01 12:00:01"}},
        Table{";", {"12:00:00,001", "12:00:00,002", "12:00:00,003"}, true},
        Table{";", {"01.02.2024 12:00:00", "01.02.2024 12:00:01", "01.02.2024 12:00:02"}, true},
        Table{"\t", {"12:00:00:000", "12:00:00:001", "12:00:00:002"}},
        Table{",", {"2024-01-01", "2024-01-02", "2024-01-03"}},
        Table{",", {"2024-01-01T12:00:00.0Z", "2024-01-01T12:00:00.1Z", "2024-01-01T12:00:01Z"}},
        Table{",",
              {"2024-01-01T12:00:00+01:00", "2024-01-01T12:00:01+01:00",
               "2024-01-01T12:00:02+01:00"}},
        Table{",", {"1/2/2024 9:59:58 AM", "1/2/2024 9:59:59 AM", "1/2/2024 10:00:00 AM"}}}) {
    std::string rows;
    for (const auto& [i, number] :
         {std::pair{0, "-0.5"}, std::pair{1, "1.25"}, std::pair{2, "2"}}) {
      std::string field = number;
      if (has_decimal_commas) std::ranges::replace(field, '.', ',');
      rows.append(times.at(i)).append(separator).append(field).append("\n");
    }
    const std::string header = "Time" + separator + "Acc\n";
    expect_read(rows, "2");
    expect_read(header + rows, "2");
    expect_read(header + rows, "Acc");
    expect_read("Logger 5\nDate: 2024-01-01\n\n" + header + rows, "Acc");
    const auto is_a_date = [](const std::string& column, const std::string& field) {
      return ", line 2: column " + column + " holds '" + field +
             "', a date or time, not a number; name a column of numbers";
    };
    expect_refused(rows, "1", is_a_date("1", times.at(1)));
    expect_refused(header + rows, "1", is_a_date("1", times.at(0)));
    expect_refused(header + rows, "Time", is_a_date("Time", times.at(0)));
    expect_refused(
        rows, "Acc",
        ", line 1: has no column Acc, because the table lacks a header; name the column by "
        "its number, 1 to 2");
    expect_refused(header + rows, "x", ", line 1: has no column x; it has Time, Acc");
    expect_refused(header + rows, "3", ", line 1: has no column 3; columns are 1 to 2");
    expect_refused("Time" + separator + "Acc" + separator + "Speed\n" + rows, "Acc",
                   ", line 1: is a header of 3 names above lines of 2 fields; name the column by "
                   "its number, 1 to 2");
  }
  // Also in long files, and below units.
  std::string dates = "Time;Acc\n";
  for (int i = 0; i < 12'000; ++i) dates += "01.02.2024 12:00:00;0,5\n";
  const std::string why = " holds '01.02.2024 12:00:00', a date or time, not a number";
  expect_refused(dates, "1", ", line 2: column 1" + why);
  expect_refused(dates, "Time", ", line 2: column Time" + why);
  std::string months = "Time,Acc\n";
  for (int i = 0; i < 12'000; ++i) months += "05-Jan-2024 10:00:00,0.5\n";
  expect_refused(months, "1",
                 ", line 2: column 1 holds '05-Jan-2024 10:00:00', not a number; name");
  expect_refused("Time;Acc\n-;g\n01.02.2024 12:00:00;0,5\n", "Time", ", line 3: column Time" + why);
  expect_refused("Time;Acc\n-;g\n01.02.2024 12:00:00;0,5\n", "1", ", line 3: column 1" + why);
  // Words do the same.
  const std::string rows = "0,-0.5,n/a\n1,1.25,n/a\n2,2,n/a\n";
  expect_read(rows, "2");
  expect_refused(rows, "x", ", line 1: has no column x, because the table lacks a header");
  expect_refused("t,x,note\n" + rows, "y", ", line 1: has no column y; it has t, x, note");
  // Damaged numbers are not called dates.
  expect_refused("0,-0.5\n1,1.234.567\n", "2",
                 ", line 2: column 2 holds '1.234.567', not a number");
}

TEST_F(InstrumentText, HasNoNamesWithoutAHeader) {
  expect_refused(
      "0,-0.5\n1,1.25\n", "acc",
      ", line 1: has no column acc, because the table lacks a header; name the column by its "
      "number, 1 to 2");
}

TEST_F(InstrumentText, IsRefusedWithASingleRow) {
  std::string row = "0.5";
  for (int i = 0; i < 200; ++i) row += ",0.5";
  expect_refused(row + '\n', "1", ", line 1: is the only line and has 201 fields");
}

}  // namespace
}  // namespace piae::raw
