#include "classification/texts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "classification/judged.hpp"
#include "support/shown.hpp"

namespace piae::classification {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::Le;
using testing::Not;

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::size_t> widths_of_lines(const std::string& text) {
  std::vector<std::size_t> widths;
  for (const std::string& line : lines_of(text)) {
    widths.push_back(width_of(line));
  }
  return widths;
}

/// Sets the height of the inner race line.
Verdict with_line(Verdict verdict, double db, bool stands_out) {
  for (inspection::FaultLine& line : verdict.lines) {
    line.db = 1;
    line.stands_out = false;
    if (line.fault_type != signal::Defect::inner) continue;
    line.db = db;
    line.stands_out = stands_out;
  }
  return verdict;
}

TEST(ClassificationTable, HasARowForEachRecording) {
  const std::string table = table_of({with_line(judged("a.csv", {1, 0, 1}), 12.34, true),
                                      with_line(judged("b.csv", {-1, 1, -1}), 2, false)},
                                     three_classes());
  EXPECT_EQ(lines_of(table),
            (std::vector<std::string>{
                "recording  named    evidence       sure  agree  unknown  windows",
                "a.csv      IR       BPFI +12.3 dB  57 %   67 %      0 %        3",
                "b.csv      unknown  no fault line     -      -     67 %        3"}));
}

TEST(SpeedsOfRecordings, AreNamedIfTheyDifferFromTheGivenOnes) {
  Verdict other = judged("a.csv", {1});
  other.recording.given_speed_rpm = 1400;
  other.recording.shaft_speed_rpm = 1400;
  other.recording.shaft = spectra::ShaftSpeed{1477, 5};
  Verdict used = other;
  used.recording.shaft_speed_rpm = 1477;
  Verdict uncertain = other;
  uncertain.recording.shaft->confidence = 1;
  EXPECT_EQ(speeds_of({judged("b.csv", {1}), other, used, uncertain}),
            "a.csv: the shaft seems to turn at 1477 rpm, 5.5 % above 1400 rpm; "
            "--speed-search-percent takes the speed from the signal\n"
            "a.csv: the shaft seems to turn at 1477 rpm, 5.5 % above 1400 rpm; this speed was "
            "used\n");
}

TEST(ClassificationTable, ShowsTheEvidence) {
  const auto row = [](const Verdict& verdict) { return table_of({verdict}, three_classes()); };
  EXPECT_THAT(row(with_line(judged("a", {1}), 2, false)), HasSubstr("BPFI +2.0 dB, faint"));
  EXPECT_THAT(row(with_line(judged("a", {0}), 2, false)), HasSubstr("no fault line"));
  // Healthy and unknown recordings show a line that should not be there.
  EXPECT_THAT(row(with_line(judged("a", {0}), 9, true)), HasSubstr("BPFI +9.0 dB "));
  EXPECT_THAT(row(with_line(judged("a", {-1}), 9, true)), HasSubstr("BPFI +9.0 dB "));
  EXPECT_THAT(row(judged("a", {1})), HasSubstr("too short for lines"));
}

TEST(ClassificationTable, ReportsAnUnknownBearing) {
  signal::DatasetInfo info = three_classes();
  info.has_bearing = false;
  EXPECT_THAT(table_of({judged("a", {1})}, info), HasSubstr("IR     bearing unknown"));
}

TEST(ClassificationTable, ShowsTheDescribedClass) {
  const std::string table = table_of({judged("a", {1}, "OR"), judged("b", {1})}, three_classes());
  EXPECT_THAT(lines_of(table)[0], HasSubstr("recording  said  named"));
  EXPECT_THAT(lines_of(table)[1], HasSubstr("a          OR    IR "));
  EXPECT_THAT(lines_of(table)[2], HasSubstr("b                IR "));
}

TEST(ClassificationTable, FitsATerminalWithNamesOfAnyLength) {
  signal::DatasetInfo info = three_classes();
  for (const std::size_t length : {1U, 8U, 22U, 100U}) {
    for (signal::ClassInfo& each : info.classes) each.name = std::string(length, 'c');
    for (const std::string& true_class : {std::string(), std::string(length, 's')}) {
      std::vector<Verdict> verdicts{
          with_line(judged(std::string(length, 'r') + ".csv", {1, 1, -1}, true_class), -12.34,
                    false),
          with_line(judged("b", {0}, true_class), 112.34, true)};
      verdicts[0].start_s.resize(9'999'999);
      EXPECT_THAT(widths_of_lines(table_of(verdicts, info)), Each(Le(80U))) << length << true_class;
    }
  }
}

// UESTC's records, of four speeds, as the network for all machines names them.
TEST(ClassificationTable, KeepsRecordsApart) {
  signal::DatasetInfo info = three_classes();
  info.classes[1].name = "inner";
  std::vector<Verdict> verdicts;
  for (const char* const name : {"healthy-1000-rpm-01", "healthy-1200-rpm-01"}) {
    verdicts.push_back(with_line(judged(name, {1}, "healthy"), 112.34, true));
    verdicts.back().can_refuse = false;
  }
  const std::string table = table_of(verdicts, info);
  EXPECT_THAT(table, HasSubstr("healthy-1000-rpm-01  healthy  inner"));
  EXPECT_THAT(table, HasSubstr("healthy-1200-rpm-01  healthy  inner"));
  EXPECT_THAT(table, Not(HasSubstr("unknown")));  // nothing can be
  EXPECT_THAT(widths_of_lines(table), Each(Le(80U)));
}

// The other columns take 59 of the 80 characters.
TEST(ClassificationTable, ShowsTheEndsOfLongNames) {
  const std::string table =
      table_of({judged("a-long-name-of-a-recording-07.csv", {1})}, three_classes());
  EXPECT_THAT(table, HasSubstr("\n..-a-recording-07.csv  IR "));
  // Characters are not cut in two, and a two-byte character counts as one.
  std::string umlauts;
  for (int i = 0; i < 30; ++i) umlauts += "\xC3\xA4";
  const std::string cut = lines_of(table_of({judged(umlauts, {1})}, three_classes()))[1];
  EXPECT_TRUE(cut.starts_with(".." + umlauts.substr(0, 2 * 19) + "  IR ")) << cut;
}

TEST(ClassificationCsv, HasALineForEachWindow) {
  const std::string csv = csv_of({judged("a,b.csv", {1, -1}), judged("c", {2})}, three_classes());
  const std::vector<std::string> lines = lines_of(csv);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0], "recording,start_s,class,probability,strangeness,unknown,p_Normal,p_IR,p_OR");
  EXPECT_THAT(lines[1], testing::MatchesRegex(
                            "\"a,b.csv\",0.000000,IR,0.8000,[01].[0-9]+,0,0.1000,0.8000,0.1000"));
  EXPECT_THAT(lines[2], testing::MatchesRegex("\"a,b.csv\",0.085333,Normal,0.8000,[0-9.]+,1,"
                                              "0.8000,0.1000,0.1000"));
  EXPECT_THAT(lines[3], testing::StartsWith("c,0.000000,OR,0.8000,"));
}

}  // namespace
}  // namespace piae::classification
