#include "inspection/tables.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "inspection/found.hpp"
#include "support/shown.hpp"

namespace piae::inspection {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

std::size_t widest_line(const std::string& text) {
  std::istringstream lines(text);
  std::size_t widest = 0;
  for (std::string line; std::getline(lines, line);) {
    widest = std::max(widest, width_of(line));
  }
  return widest;
}

TEST(CheckTables, ShowLevelsLinesAndClasses) {
  Found found;
  found.check.records[1].shaft = spectra::ShaftSpeed{1477.2, 3};
  found.check.records[2].shaft = spectra::ShaftSpeed{1477.2, 1};
  const std::string text = tables_of(found.description, found.check);
  EXPECT_THAT(text, HasSubstr("file Hz     Hz       s  windows  RMS g  kurtosis  crest\n"));
  EXPECT_THAT(text,
              ContainsRegex("ok +ok.csv +12000  12000  10.000      117      1      3.00   4.00"));
  EXPECT_THAT(text, ContainsRegex("outer +1797 +1477   107.34  \\*20.0 "));
  EXPECT_THAT(text, ContainsRegex("inner +1797 +-   107.34    1.0   162.21  \\*20.0   141.0[0-9]"));
  EXPECT_THAT(text, ContainsRegex("ball +roller +0.5 +1 +200 +80.0 +8\n"));
  EXPECT_LE(widest_line(text), 100U);
}

TEST(CheckTables, ShowTheLinesOfAnUnknownBearing) {
  Found found;
  found.description.info.has_bearing = false;
  std::vector<RecordCheck>& records = found.check.records;
  records[1].shaft = spectra::ShaftSpeed{1477.2, 3};
  records[1].unknown_line = UnknownLine{
      Likeness::outer, 3.5851, 25.24, true, {"SKF 6205-2RS JEM", "SKF 6205", "NSK 6205 DDU"}};
  records[2].unknown_line = UnknownLine{Likeness::outer_or_inner, 5.4, 12, false, {}};
  records[3].unknown_line = UnknownLine{.db = 3.3};
  const std::string text = tables_of(found.description, found.check);
  EXPECT_THAT(text,
              ContainsRegex(
                  "outer +outer race +high +SKF 6205-2RS JEM, SKF 6205 \\+1 +1477 +3.585 +25.2\n"));
  EXPECT_THAT(text, ContainsRegex("inner +outer or inner +fair +- +1797 +5.400 +12.0\n"));
  EXPECT_THAT(text, ContainsRegex("ball +none can be named +- +- +1797 +- +3.3\n"));
  EXPECT_LE(widest_line(text), 100U);
}

TEST(CheckTables, FitIntoAHundredColumnsWhateverTheNames) {
  Found found;
  const std::string long_name(60, 'x');
  for (auto& c : found.description.info.classes) c.name += long_name;
  for (RecordCheck& record : found.check.records) {
    record.source.name += long_name + "-01";
    record.source.files = {long_name + "/größer-als-Kästchen-erlauben/" +
                           record.source.file_text()};
    record.source.sample_rate_hz = 51200.5;
    record.level = Level{1.234e-5, 12345.67, 123.45};
  }
  found.description.info.unit_m_per_s2 = 0.001;
  const std::string text = tables_of(found.description, found.check);
  EXPECT_LE(widest_line(text), 100U) << text;
  EXPECT_THAT(text, HasSubstr("-01  …"));
  EXPECT_THAT(text, HasSubstr("outer.csv"));
  EXPECT_THAT(text, HasSubstr("RMS units"));
}

/// 2560 samples hold two windows of 1024 side by side, and 1000 none.
TEST(CheckTables, CountFilesAndTheirWindows) {
  Found found;
  RecordCheck& record = found.check.records[0];
  record.source.files = {"acc_*.csv"};
  record.files = {{"acc_1.csv", 2560, 6}, {"acc_2.csv", 1000, 6}, {"acc_3.csv", 2560, 6}};
  record.pieces = {2560, 1000, 2560};
  record.file_samples = 6120;
  EXPECT_THAT(tables_of(found.description, found.check),
              ContainsRegex("ok +acc_\\*.csv \\(3 files\\) +12000  12000   0.510        4 "));
}

TEST(CheckTables, ShowADashForUnknownValues) {
  Found found;
  found.check.records[0].problem = "ok.csv: no such file";
  found.check.records[0].level.reset();
  found.check.records[1].level.reset();
  for (FaultLine& line : found.check.records[1].lines) {
    line.db.reset();
    line.noise_db = 0;
  }
  const std::string text = tables_of(found.description, found.check);
  EXPECT_THAT(text, HasSubstr("no data\n"));
  EXPECT_THAT(text, ContainsRegex("outer +outer.csv +12000  12000  10.000      117\n"));
  EXPECT_THAT(text, ContainsRegex("outer +1797 +- +107.34 +\\*- +162.21 +- +141.0[0-9] +- +-\n"));
}

TEST(UnitName, NamesTheUnit) {
  EXPECT_EQ(unit_name(1), "units");
  EXPECT_EQ(unit_name(9.81), "g");
  EXPECT_EQ(unit_name(0.00980665), "mg");
  EXPECT_EQ(unit_name(0.001), "units");
}

}  // namespace
}  // namespace piae::inspection
