#include "inspection/warnings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "inspection/found.hpp"

namespace piae::inspection {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<std::string> warnings_of(const Found& found) {
  return inspection::warnings_of(found.description, found.check);
}

/// Expects a single warning in one line with all these words.
void expect_one(const Found& found, const std::vector<std::string>& words) {
  const std::vector<std::string> warnings = warnings_of(found);
  ASSERT_EQ(warnings.size(), 1U) << testing::PrintToString(warnings);
  for (const std::string& word : words) EXPECT_THAT(warnings.front(), HasSubstr(word));
  EXPECT_THAT(warnings.front(), Not(HasSubstr("\n")));
}

void set_speed(Found& found, double rpm) {
  found.description.info.shaft_speed_rpm = rpm;
  for (auto& source : found.description.records) source.shaft_speed_rpm = rpm;
  for (RecordCheck& record : found.check.records) record.source.shaft_speed_rpm = rpm;
}

TEST(Warnings, AreNoneForGoodRecordings) { EXPECT_THAT(warnings_of(Found()), IsEmpty()); }

/// No further warning: turns and lines follow from the speed.
TEST(Warnings, NameASpeedInHzOnce) {
  Found found;
  set_speed(found, 29.95);
  for (RecordCheck& record : found.check.records) {
    for (FaultLine& line : record.lines) Found::set(line, 0);
  }
  expect_one(found, {"shaft_speed_rpm = 29.95", "Hz", "1797 rpm", "60 times"});
}

TEST(Warnings, NameTheRecordThatHasASpeedInHzOfItsOwn) {
  Found found;
  found.description.records[2].shaft_speed_rpm = 25;
  found.check.records[2].source.shaft_speed_rpm = 25;
  expect_one(found, {"inner (inner.csv, variable 2): shaft_speed_rpm = 25", "1500 rpm"});
}

TEST(Warnings, NameRacewaysThatAreBoreAndOutsideDiameter) {
  Found found;
  found.description.info.bearing.inner_raceway_mm = 25;
  found.description.info.bearing.outer_raceway_mm = 52;
  expect_one(found, {"inner_raceway_mm = 25", "outer_raceway_mm = 52", "bore and outside diameter",
                     "13.5 mm for a ball of 7.94 mm", "38.5 mm", "31.06 and 46.94"});
}

/// 1024 / 12000 s * 60 / 60 Hz.
TEST(Warnings, NameTheRateThatLeavesNoTurnInAWindow) {
  Found found;
  found.description.info.sample_rate_hz = 48000;
  for (RecordCheck& record : found.check.records) record.source.sample_rate_hz = 48000;
  for (auto& source : found.description.records) source.shaft_speed_rpm = 1797;
  found.description.records[1].shaft_speed_rpm = 1200;
  expect_one(found,
             {"sample_rate_hz = 48000", "1024 samples (0.0213 s)", "0.43 turns", "1200 rpm"});
}

TEST(Warnings, NameARateInKHzByItsHalf) {
  Found found;
  found.description.info.sample_rate_hz = 12;
  expect_one(found, {"sample_rate_hz = 12", "BPFI, 162.2 Hz", "kHz"});
}

TEST(Warnings, NameARecordOfMoreThanAnHour) {
  Found found;
  found.check.records[1].source.sample_rate_hz = 12;
  found.check.records[1].level.reset();
  for (FaultLine& line : found.check.records[1].lines) line.db.reset();
  expect_one(found, {"outer (outer.csv, variable 2): 120000 samples at sample_rate_hz = 12",
                     "2.8 hours", "kHz", "not resampled"});
}

TEST(Warnings, NameManyRecordsOfMoreThanAnHourInOneLine) {
  Found found;
  for (RecordCheck& record : found.check.records) {
    record.source.sample_rate_hz = 12;
    for (FaultLine& line : record.lines) line.db.reset();
  }
  expect_one(found, {"ok (ok.csv, variable 2): 120000", "2.8 hours",
                     "(the same holds for outer, inner, ball)"});
}

/// 120000 / 12e6 s = 0.01 s, 0.2995 turns.
TEST(Warnings, NameARecordOfLessThanTenTurns) {
  Found found;
  found.check.records[1].source.sample_rate_hz = 12e6;
  for (FaultLine& line : found.check.records[1].lines) line.db.reset();
  expect_one(found, {"outer (outer.csv, variable 2): 120000 samples at sample_rate_hz = 1.2e+07",
                     "0.01 s", "0.3 turns"});
}

/// Too short files are not searched for lines. 0.1 s at 1797 rpm are 3 turns, so any line may
/// appear.
TEST(Warnings, DoNotMentionLinesOfTooShortFiles) {
  Found found;
  RecordCheck& healthy = found.check.records[0];
  for (int i = 0; i < 100; ++i) healthy.files.push_back({"acc_" + std::to_string(i), 1200, 1});
  Found::set(healthy.lines[0], 20);
  expect_one(found, {"120000 samples at sample_rate_hz = 12000 are 0.1 s a file",
                     "3 turns of the shaft: fewer than 10"});
}

TEST(Warnings, NameATimeColumn) {
  Found found;
  RecordCheck& record = found.check.records[1];
  record.goes_one_way = true;
  record.held = {1, 50, 50, 7, 0};
  for (FaultLine& line : record.lines) Found::set(line, 0);
  expect_one(found, {"outer (outer.csv, variable 2): ", "only rise or only fall", "a time"});
}

TEST(Warnings, NameClippedSamples) {
  Found found;
  found.check.records[2].clipped = {7, 31, 6, 4711, -4.99};
  expect_one(found, {"inner (inner.csv, variable 2): clipped: 31 samples in 7 stretches",
                     "6 samples at -4.99 from sample 4711"});
}

TEST(Warnings, NamePeaksThatAreClippedToOneSample) {
  Found found;
  found.check.records[2].cut_tops = {1200, 0, 4.99, -3.2};
  expect_one(found, {"inner (inner.csv, variable 2): clipped: 1200 samples, 1 % of the record, lie "
                     "exactly on the highest value (4.99), more"});
  found.check.records[2].cut_tops = {700, 500, 4.99, -5};
  expect_one(found, {"1200 samples", "on the highest value (4.99) or the lowest (-5), more"});
  found.check.records[2].clipped = {7, 31, 6, 4711, -4.99};
  expect_one(found, {"clipped: 31 samples in 7 stretches"});
}

TEST(Warnings, WriteAWholeRecordInPercent) {
  Found found;
  RecordCheck& record = found.check.records[2];
  record.cut_tops = {static_cast<std::size_t>(record.file_samples), 0, 4.99, -3.2};
  expect_one(found, {"samples, 100 % of the record, lie"});
}

/// Lines and levels follow from the dead sensor and are not reported.
TEST(Warnings, NameFewDistinctValues) {
  Found found;
  RecordCheck& record = found.check.records[1];
  record.few_values = 4;
  record.cut_tops = {1200, 0, 4.99, -3.2};
  record.level->rms = 1e-4;
  Found::set(found.line(1, 0), 0);
  expect_one(found,
             {"outer (outer.csv, variable 2): has only 4 distinct values; the sensor is dead"});
}

TEST(Warnings, NameIsolatedSpikes) {
  Found found;
  found.check.records[0].lone = {1, 1000, 300, 1.0725};
  expect_one(found, {"ok (ok.csv, variable 2): sample 1000 (300) is an isolated spike",
                     "farther than 1.07 ", "a spike"});
  found.check.records[0].lone = {3, 1000, 300, 1.0725};
  expect_one(found, {"sample 1000 (300) and 2 more are isolated spikes"});
}

/// 3000 of 120000 samples.
TEST(Warnings, NameStretchesThatRepeat) {
  Found found;
  found.check.records[0].repeats = {1, 3000, 3000, 60000, 512};
  expect_one(found, {"ok (ok.csv, variable 2): samples 60000 to 62999 repeat samples 512 to 3511 "
                     "exactly, 2.5 % of the record",
                     "PROTOCOL=blocked"});
  found.check.records[0].repeats = {2, 3600, 3000, 60000, 512};
  expect_one(found, {"exactly (the longest of 2 such stretches), 3 % of"});
}

/// Samples of a record of several files are counted in their file.
TEST(Warnings, NameTheFileOfASample) {
  Found found;
  RecordCheck& record = found.check.records[0];
  record.files = {{.name = "a.csv", .samples = 60000}, {.name = "b.csv", .samples = 60000}};
  record.lone = {1, 70000, 300, 1.0725};
  expect_one(found, {"sample 10000 of b.csv (300) is an isolated spike"});
  record.lone = {};
  record.repeats = {1, 3000, 3000, 70000, 512};
  expect_one(found,
             {"samples 10000 to 12999 of b.csv repeat samples 512 to 3511 of a.csv exactly"});
  record.repeats = {1, 3000, 3000, 58000, 512};
  expect_one(found, {"sample 58000 of a.csv to sample 999 of b.csv repeat samples 512 to"});
  record.repeats = {};
  record.clipped = {7, 31, 6, 59999, -4.99};
  expect_one(found, {"6 samples at -4.99 from sample 59999 of a.csv"});
}

TEST(Warnings, NameSamplesThatAreMissing) {
  Found found;
  raw::Times times{.column = 1, .gaps = 1, .missing = 1, .longest = 1, .longest_after = 4710};
  found.check.records[0].files = {{.name = "ok.csv", .samples = 120000, .times = times}};
  expect_one(found, {"ok (ok.csv, variable 2): the times in column 1 jump 1 time: 1 sample is "
                     "missing; the longest gap, of 1, follows sample 4710"});
  times = {.column = 2, .gaps = 3, .missing = 50, .longest = 40, .longest_after = 4710};
  found.check.records[0].files[0].times = times;
  expect_one(found, {"column 2 jump 3 times: 50 samples are missing; the longest gap, of 40,"});
}

TEST(Warnings, NameTimesThatGoBack) {
  Found found;
  const raw::Times times{.column = 1, .steps_back = 2, .first_back_after = 59999};
  found.check.records[0].files = {{.name = "ok.csv", .samples = 120000, .times = times}};
  expect_one(found, {"ok (ok.csv, variable 2): the times in column 1 go back 2 times, first after "
                     "sample 59999: several recordings"});
}

TEST(Warnings, NameAFileThatMayBeCut) {
  Found found;
  found.check.records[0].files = {{.name = "ok.csv", .samples = 120000, .may_be_cut = true}};
  expect_one(found, {"ok (ok.csv, variable 2): the last number has no line end and is shorter than "
                     "95 % of the others, so the file may be cut off"});
}

TEST(Warnings, NameUnevenTimes) {
  Found found;
  const raw::Times times{.column = 1, .is_named = true, .is_uneven = true, .mean_step = 1. / 12000};
  found.check.records[0].files = {{.name = "ok.csv", .samples = 120000, .times = times}};
  expect_one(found, {"ok (ok.csv, variable 2): the times in column 1 step unevenly, by 8.33e-05 on "
                     "average; spectra of such samples are wrong"});
}

TEST(Warnings, NameTimesOfAnotherRate) {
  Found found;
  raw::Times times{.column = 1, .is_named = true, .step = 1. / 20000, .mean_step = 1. / 20000};
  found.check.records[0].files = {{.name = "ok.csv", .samples = 120000, .times = times}};
  expect_one(found, {"ok (ok.csv, variable 2): the times in column 1 step by 5e-05, which "
                     "would be 20000 Hz in s, but sample_rate_hz = 12000"});
  times.step = times.mean_step = 1000. / 20000;
  found.check.records[0].files[0].times = times;
  expect_one(found, {"step by 0.05, which would be 20000 Hz in ms, but"});
}

TEST(Warnings, NameARecordOfALowerRateThanTheDataSet) {
  Found found;
  found.check.records[1].source.sample_rate_hz = 600;
  expect_one(found, {"outer (outer.csv, variable 2): sample_rate_hz = 600 is below the data set's "
                     "12000: nothing above 300 Hz exists"});
  for (RecordCheck& record : found.check.records) record.source.sample_rate_hz = 6000;
  expect_one(found, {"ok (ok.csv, variable 2): sample_rate_hz = 6000", "to 6000 or less",
                     "(the same holds for outer, inner, ball)"});
}

/// All other records have an RMS of 1.
TEST(Warnings, NameAnImplausibleLevel) {
  Found found;
  found.check.records[1].level->rms = 199;
  found.check.records[2].level->rms = 0.0051;
  EXPECT_THAT(warnings_of(found), IsEmpty());
  found.check.records[1].level->rms = 5600;
  expect_one(found, {"outer (outer.csv, variable 2): its RMS, 5600, is 5600 times that of the "
                     "healthy records, 1, ",
                     "unit or scale"});
  found.check.records[1].level->rms = 1;
  found.check.records[2].level->rms = 0.0019;
  expect_one(found, {"inner (inner.csv, variable 2): its RMS, 0.0019, is 0.0019 times"});
}

/// 1200 of 120000 samples at 12 kHz.
TEST(Warnings, NameARecordedSpeedThatIsFarFromTheDescribedOne) {
  Found found;
  RecordCheck& record = found.check.records[1];
  record.source.speed.emplace();
  record.source.shaft_speed_rpm = 1797 * 1.4;
  EXPECT_THAT(warnings_of(found), IsEmpty());
  record.source.shaft_speed_rpm = 1797 * 60;
  EXPECT_THAT(warnings_of(found),
              Contains(AllOf(HasSubstr("its recorded speed is 1.0782e+05 rpm in the mean, but "
                                       "shaft_speed_rpm = 1797 of the data set"),
                             HasSubstr("pulses_per_turn"))));
}

TEST(Warnings, DoNotNameASpeedThatIsTakenFromTheSignal) {
  Found found;
  found.check.records[1].shaft = spectra::ShaftSpeed{1797 * 1.055, 9};
  EXPECT_FALSE(warnings_of(found).empty());
  found.description.speed_search_percent = 10;
  EXPECT_THAT(warnings_of(found), IsEmpty());
}

// The lines of an unknown bearing need fifty turns, and the table of bearings.
TEST(Warnings, NameWhatAnUnknownBearingNeeds) {
  Found found;
  found.description.info.has_bearing = false;
  for (RecordCheck& record : found.check.records) {
    record.order_lines = Eigen::ArrayXd::Zero(10);
    record.unknown_line.emplace();
  }
  found.description.bearing_table = "nowhere/bearings.csv";
  expect_one(found, {"nowhere/bearings.csv is missing", "copy pipeline/bearings.csv there"});
  found.description.bearing_table = __FILE__;
  EXPECT_THAT(warnings_of(found), IsEmpty());
  found.check.records.back().order_lines.resize(0);
  expect_one(found, {"too few to name its fault line without a [bearing]; use 50 or more"});
}

TEST(Warnings, NameTheSpeedThatTheShaftShows) {
  Found found;
  found.check.records[0].shaft = spectra::ShaftSpeed{1797 * 1.009, 9};
  found.check.records[1].shaft = spectra::ShaftSpeed{1797 * 1.055, 2.5};
  found.check.records[2].shaft = spectra::ShaftSpeed{1797 * 1.055, 2.4};
  found.check.records[3].shaft = spectra::ShaftSpeed{1797 * 0.97, 2.5};
  Found::set(found.line(3, 2), 0);  // a line that such a speed hides
  EXPECT_THAT(
      warnings_of(found.description, found.check),
      ElementsAre(HasSubstr("outer (outer.csv, variable 2): the shaft seems to turn at 1896 rpm, "
                            "5.5 % above shaft_speed_rpm = 1797, and so do"),
                  HasSubstr("ball (ball.csv, variable 2): the shaft seems to turn at 1743 rpm, "
                            "3.0 % below shaft_speed_rpm = 1797, and so do")));
}

TEST(Warnings, NameStretchesOfOneValue) {
  Found found;
  found.check.records[0].held = {3, 2400, 1200, 5000, 0};
  expect_one(found, {"ok (ok.csv, variable 2): constant at 0 for 1200 samples (0.1 s) from "
                     "sample 5000; 3 such stretches, 2 % of the record"});
}

TEST(Warnings, NameAStrideBelowAHundredAndItsOverlap) {
  Found found;
  found.check.classes[3] = {3, 1, 100, 0.902, 0.16, ""};
  EXPECT_THAT(warnings_of(found), IsEmpty());
  found.check.classes[3] = {3, 1, 20, 0.9805, 0.58, ""};
  expect_one(found, {"class ball: ", "every 20", "overlap by 98.0 %",
                     "PROTOCOL=random 58 % of the test windows", "PROTOCOL=blocked"});
}

TEST(Warnings, NameAFaultThatDoesNotShowItsLine) {
  Found found;
  Found::set(found.line(3, 2), 1);
  expect_one(found, {"ball (ball.csv, variable 2): 2BSF (141.0 Hz, 1.0 dB), the line of its class, "
                     "does not stand out: noise alone reaches 1.6 dB; the label"});
  Found::set(found.line(3, 2), 2.5);
  expect_one(found,
             {"does not stand out: 40 % of the frequencies without a fault line stand out as far"});
  found.line(3, 2).harmonics_above_noise = 1;
  expect_one(found, {"does not stand out: only one of its harmonics does; the label"});
  Found::set(found.line(3, 0), 8);
  expect_one(found, {"; BPFO (107.3 Hz, 8.0 dB) does; "});
}

TEST(Warnings, NameAFaultThatShowsAnotherLineMoreClearly) {
  Found found;
  Found::set(found.line(1, 1), 25);
  expect_one(found, {"outer (outer.csv, variable 2): BPFI (162.2 Hz, 25.0 dB) stands out more than "
                     "BPFO (107.3 Hz, 20.0 dB), the line of its class"});
}

TEST(Warnings, NameSpeedAndRateIfMostFaultsMissTheirLines) {
  Found found;
  Found::set(found.line(0, 1), 9.3);  // follows from the same error
  found.line(1, 0).stands_out = false;
  found.line(2, 1).stands_out = false;
  found.line(3, 2).stands_out = false;
  expect_one(found, {"only 0 of 3 faulty records", "(not outer, inner, ball)", "shaft_speed_rpm"});
}

/// Three of three records of three fault types, within 2 %: by chance in one of 400.
TEST(Warnings, NameTheFactorByWhichAllLinesAreOff) {
  Found found;
  const std::vector<double> factors{0.95, 0.948, 0.956};
  const auto move = [&](std::size_t i, double factor) {
    const Label label = static_cast<Label>(i + 1);
    FaultLine& line = found.line(label, i);
    Found::set(line, 1);
    line.farthest_factor = factor;
  };
  const std::vector<std::size_t> own{0, 1, 2};  // outer, inner, ball
  for (const std::size_t i : own) move(i, factors[i]);
  expect_one(found,
             {"3 of 3 faulty records show the line of their class at 0.95 times its frequency "
              "(outer, inner, ball)",
              "for outer, try shaft_speed_rpm = 1707 instead of 1797",
              "sample_rate_hz = 1.263e+04 instead of 12000"});
  move(2, 1.3);  // two of three may agree by chance
  EXPECT_THAT(warnings_of(found), ElementsAre(HasSubstr("only 0 of 3 faulty records")));
  move(2, 0.95);
  found.line(3, 2).stands_out = true;  // at its own place
  EXPECT_THAT(warnings_of(found), Not(Contains(HasSubstr("times its frequency"))));
  for (const std::size_t i : own) move(i, 1.01);  // within slip
  EXPECT_THAT(warnings_of(found), ElementsAre(HasSubstr("only 0 of 3 faulty records")));
}

/// A line of the shaft has one frequency, whatever the fault.
TEST(Warnings, IgnoreAFactorOfASingleFaultType) {
  Found found;
  for (const Label label : {1, 2, 3}) {
    found.check.records[index_of(label)].source.label = 1;
    FaultLine& line = found.line(label, 0);
    Found::set(line, 1);
    Found::set(found.line(label, 1), 1);
    Found::set(found.line(label, 2), 1);
    line.farthest_factor = 0.84;
  }
  EXPECT_THAT(warnings_of(found), ElementsAre(HasSubstr("only 0 of 3 faulty records")));
}

TEST(Warnings, NameAHealthyRecordThatShowsALine) {
  Found found;
  Found::set(found.line(0, 1), 9.3);
  expect_one(found, {"ok (ok.csv, variable 2): healthy, but BPFI (162.2 Hz, 9.3 dB) stands out: "
                     "noise alone reaches 1.6 dB, the weakest record of such a fault 20.0 dB"});
}

TEST(Warnings, IgnoreUnreadableRecords) {
  Found found;
  found.check.records[1] = {};
  found.check.records[1].source = found.description.records[1];
  found.check.records[1].problem = "outer.csv: no such file";
  found.check.classes[1] = {1, 1, 0, 0, 0, ""};
  EXPECT_THAT(warnings_of(found), IsEmpty());
}

}  // namespace
}  // namespace piae::inspection
