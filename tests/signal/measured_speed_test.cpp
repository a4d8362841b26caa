#include "signal/measured_speed.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "signal/ingest.hpp"
#include "support/drifting_shaft.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"
#include "support/turning_shaft.hpp"

namespace piae::signal {
namespace {

std::vector<double> even_pulses(double step_s, double until_s) {
  std::vector<double> times_s;
  for (int i = 0; i * step_s <= until_s; ++i) times_s.push_back(i * step_s);
  return times_s;
}

TEST(Pulses, AreSharesOfATurn) {
  const ShaftAngle angle = angle_of_pulses(even_pulses(0.01, 1), 4, 1, "tacho.csv");
  EXPECT_EQ(angle.turns[40], 10);
  EXPECT_NEAR(speed_course(angle, 1, 0).mean_rpm(0.3, 0.7), 60 * 25, 1e-9);
}

void expect_refused(const std::vector<double>& times_s, double pulses_per_turn,
                    const std::string& text) {
  EXPECT_ERROR(angle_of_pulses(times_s, pulses_per_turn, 1, "tacho.csv"), Exit::bad_input,
               "tacho.csv: " + text);
}

TEST(Pulses, AreRefusedInOneLine) {
  std::vector<double> times_s = even_pulses(0.05, 1);
  expect_refused({0, 1}, 1, "holds 2 pulses, but a speed over time needs 3 or more");
  expect_refused(times_s, 1e-4, "the pulses at 0 and 0.05 s make a speed of 1.2e+07 rpm");
  expect_refused(even_pulses(0.05, 0.8), 1, "the pulses from 0 to 0.8 s do not cover the record");
  std::vector<double> late;
  for (const double time_s : times_s) late.push_back(time_s + 0.2);
  expect_refused(late, 1, "the pulses from 0.2 to 1.2 s do not cover the record, which lasts 1 s");
  std::vector<double> missing = times_s;
  missing.erase(missing.begin() + 7);
  expect_refused(missing, 1, "the time from pulse to pulse changes from 0.05 to 0.1 s at 0.3 s");
  for (const double wrong : {0.2, 0.1, std::numeric_limits<double>::quiet_NaN()}) {
    times_s[5] = wrong;
    expect_refused(times_s, 1, "time 6 of the pulses");
  }
}

/// A record of 2 s at 1000 Hz whose file holds a speed, too, and another file its pulses.
class RecordedSpeed : public testing::Test {
 protected:
  RecordedSpeed() {
    const std::vector<double> signal = turning_shaft(600, 2000, 1000);
    std::string text = "acceleration,speed\n";
    for (std::size_t i = 0; i < signal.size(); ++i) {
      text += std::to_string(signal[i]) + "," + std::to_string(i < 1000 ? 600 : 630) + "\n";
    }
    folder_.write("run.csv", text);
    folder_.write("tacho.csv", column_of(shaft_.times_s(2)));
    source_ = {.name = "run",
               .label = 0,
               .files = {"run.csv"},
               .variable = "acceleration",
               .sample_rate_hz = 1000,
               .shaft_speed_rpm = 1234,
               .sha256 = "",
               .url = ""};
    description_.info.name = "rig";
    description_.info.sample_rate_hz = 1000;
    description_.info.shaft_speed_rpm = 1234;
    description_.info.classes = {{"ok", Defect::none, 0}};
  }
  Record read(const SpeedSource& speed) {
    source_.speed = speed;
    return RecordReader(description_, folder_.path()).read(source_);
  }
  void expect_refused(const SpeedSource& speed, Exit exit, const std::string& text) {
    EXPECT_ERROR(read(speed), exit, text);
  }
  const DriftingShaft shaft_{.mean_rpm = 600, .drift = 0.1, .duration_s = 2};
  const Folder folder_;
  Description description_;
  RecordSource source_;
};

TEST_F(RecordedSpeed, IsThatOfAChannel) {
  const Record record = read({.variable = "speed"});
  ASSERT_TRUE(record.speeds);
  EXPECT_NEAR(record.shaft_speed_rpm, 615, 1e-6);
  EXPECT_NEAR(record.speed_rpm(500, 400, 1000), 600, 1e-6);
  EXPECT_NEAR(record.speed_rpm(900, 200, 1000), 615, 1e-6);
  EXPECT_EQ(record.files.size(), 1U);
}

TEST_F(RecordedSpeed, IsThatOfPulses) {
  const Record record = read({.file = "tacho.csv", .variable = "1", .pulses_per_turn = 2});
  ASSERT_TRUE(record.speeds);
  EXPECT_NEAR(record.shaft_speed_rpm, 600, 0.2);
  EXPECT_NEAR(record.speed_rpm(0, 500, 1000) / shaft_.rpm_at(0.25), 1, 1e-3);
  EXPECT_NEAR(record.speed_rpm(1500, 500, 1000) / shaft_.rpm_at(1.75), 1, 1e-3);
  ASSERT_EQ(record.files.size(), 2U);
  EXPECT_EQ(record.files[1].name, "tacho.csv");
  EXPECT_EQ(record.files[1].sha256.size(), 64U);
}

TEST_F(RecordedSpeed, IsRefusedInOneLine) {
  folder_.write("zeros.csv", "1,0\n2,0\n3,0\n4,0\n");
  expect_refused({.variable = "rpm"}, Exit::bad_input, "run.csv");
  expect_refused({.file = "none.csv", .variable = "1"}, Exit::input_missing,
                 "none.csv (record run): no such file; correct shaft_speed_rpm.file");
  expect_refused({.file = "zeros.csv", .variable = "2"}, Exit::bad_input,
                 "zeros.csv (record run): time 2 of the pulses, 0 s, does not follow");
  source_.files = {"zeros.csv"};
  source_.variable = "1";
  expect_refused({.variable = "2"}, Exit::bad_input,
                 "zeros.csv (record run): 2: is 0 at sample 0 (counted from 0), but a shaft speed "
                 "must be from 0.01");
  source_.files = {"run.csv", "zeros.csv"};
  expect_refused({.file = "tacho.csv", .variable = "1"}, Exit::bad_input,
                 "tacho.csv (record run): holds the pulses of one recording, but the record has 2 "
                 "files");
}

}  // namespace
}  // namespace piae::signal
