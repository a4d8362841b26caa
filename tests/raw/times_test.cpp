#include "raw/times.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "raw/file.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::raw {
namespace {

using Numbers = std::vector<double>;

/// Returns rounded times at a rate, without `count` samples from `first` on.
Numbers times_without(std::size_t first, std::size_t count, double resolution_s = 1e-6,
                      double rate_hz = 12000) {
  Numbers times;
  for (std::size_t i = 0; i < 5000; ++i) {
    if (i >= first && i < first + count) continue;
    times.push_back(std::round(static_cast<double>(i) / rate_hz / resolution_s) * resolution_s);
  }
  return times;
}

Times unnamed(const Numbers& numbers) { return times_in(numbers, {.column = 1}); }
Times named(const Numbers& numbers, double unit_s = 0) {
  return times_in(numbers, {.column = 1, .unit_s = unit_s, .is_named = true});
}

TEST(TimeNames, GiveTheirUnit) {
  for (const std::string name :
       {"Time (s)", "t[s]", "Zeit/s", "time_s", "Time, s", "seconds", "\xE6\x97\xB6\xE9\x97\xB4(s)",
        "TIME <sec>", "t / s", "Temps (s)", "X axis (s)"}) {
    EXPECT_TRUE(time_name(name).is_time) << name;
    EXPECT_EQ(time_name(name).unit_s, 1) << name;
  }
  EXPECT_EQ(time_name("Time (ms)").unit_s, 1e-3);
  EXPECT_EQ(time_name("elapsed_us").unit_s, 1e-6);
  EXPECT_EQ(time_name("millis").unit_s, 1e-3);
  EXPECT_EQ(time_name("t (\xC2\xB5s)").unit_s, 1e-6);
  EXPECT_EQ(time_name("(ms)").unit_s, 1e-3) << "a line of units";
  EXPECT_EQ(time_name("s").unit_s, 1);
  EXPECT_FALSE(time_name("s").is_time);
  for (const std::string name : {"time", "Time - Voltage_0", "t", "Timestamp", "Time (UTC)"}) {
    EXPECT_TRUE(time_name(name).is_time) << name;
    EXPECT_EQ(time_name(name).unit_s, 0) << name;
  }
  for (const std::string name : {"acc_s", "Velocity (m/s)", "Timer", "T", "T (degC)", "", "x",
                                 "Temperature", "ax [m/s^2]", "Index", "h"}) {
    EXPECT_FALSE(time_name(name).is_time) << name;
    EXPECT_EQ(time_name(name).unit_s, 0) << name;
  }
}

TEST(Times, ShowMissingSamples) {
  const Times one = unnamed(times_without(1234, 1));
  EXPECT_EQ(one.gaps, 1U);
  EXPECT_EQ(one.missing, 1U);
  EXPECT_EQ(one.longest_after, 1233U);
  Numbers times = times_without(2000, 300);
  times.erase(times.begin() + 700, times.begin() + 705);
  const Times two = unnamed(times);
  EXPECT_EQ(two.gaps, 2U);
  EXPECT_EQ(two.missing, 305U);
  EXPECT_EQ(two.longest, 300U);
  EXPECT_EQ(two.longest_after, 1994U);
}

TEST(Times, ShowNoMissingSamplesIfWholeOrCoarse) {
  for (const double resolution_s : {1e-6, 1e-5, 1e-4, 1e-3}) {
    EXPECT_EQ(unnamed(times_without(0, 0, resolution_s)).gaps, 0U) << resolution_s;
  }
  EXPECT_EQ(unnamed({}).gaps, 0U);
  EXPECT_EQ(unnamed({0, 1, 2, 5, 6}).gaps, 0U);
}

/// At 952 Hz about every twentieth time skips a millisecond.
TEST(Times, AreDistinguishedFromRoundedOnesByTheRate) {
  EXPECT_TRUE(are_rounded(named(times_without(0, 0, 1e-3, 952)), 952));
  EXPECT_FALSE(are_rounded(named(times_without(1234, 300, 1e-3, 1000)), 1000));
  Numbers every_tenth_lost;
  for (int i = 0; i < 5000; ++i) {
    if (i % 10 != 0) every_tenth_lost.push_back(i / 1000.);
  }
  EXPECT_FALSE(are_rounded(unnamed(every_tenth_lost), 1000));
}

TEST(Times, AreNotFoundInASignal) {
  Numbers signal;
  for (int i = 0; i < 5000; ++i) signal.push_back(std::sin(0.7 * i));
  for (const Times& times : {unnamed(signal), named(signal)}) {
    EXPECT_EQ(times.column, 0U);
    EXPECT_EQ(times.gaps, 0U);
    EXPECT_FALSE(contradicting_rate(times, 25600));
  }
}

TEST(Times, ShowStepsBack) {
  Numbers times = times_without(0, 0);
  const Numbers again = times;
  times.insert(times.end(), again.begin(), again.end());
  EXPECT_EQ(unnamed(times).steps_back, 1U);
  EXPECT_EQ(unnamed(times).first_back_after, 4999U);
  EXPECT_EQ(unnamed(times).gaps, 0U);
  Numbers angle;
  for (int i = 0; i < 5000; ++i) angle.push_back(i % 100 * 3.6);
  EXPECT_EQ(unnamed(angle).steps_back, 0U) << "of a wheel";
}

TEST(Times, ContradictARate) {
  const Numbers times = times_without(0, 0);
  EXPECT_FALSE(contradicting_rate(unnamed(times), 12000));
  EXPECT_FALSE(contradicting_rate(unnamed(times), 12100));
  const auto other = contradicting_rate(unnamed(times), 48000);
  ASSERT_TRUE(other);
  EXPECT_NEAR(other->hz, 12000, 1);
  EXPECT_EQ(other->unit_s, 1);
  EXPECT_TRUE(contradicting_rate(unnamed(times), 12130));
  EXPECT_TRUE(contradicting_rate(unnamed(times_without(1000, 500)), 48000)) << "with a gap";
  EXPECT_FALSE(contradicting_rate(unnamed(times_without(1000, 500)), 12000));
}

TEST(Times, MayBeInAnyUnitIfTheNameHasNone) {
  Numbers ms = times_without(0, 0);
  for (double& time : ms) time *= 1000;
  EXPECT_FALSE(contradicting_rate(named(ms), 12000));
  EXPECT_FALSE(contradicting_rate(named(ms, 1e-3), 12000));
  const auto as_s = contradicting_rate(named(ms, 1), 12000);
  ASSERT_TRUE(as_s);
  EXPECT_NEAR(as_s->hz, 12, 0.01);
  const auto other = contradicting_rate(named(ms), 25600);
  ASSERT_TRUE(other);
  EXPECT_NEAR(other->hz, 12000, 1);
  EXPECT_EQ(other->unit_s, 1e-3);
}

/// Times such as steps of 39 us printed as 30 or 40, or 0.0833 ms printed as 0 or 1 ms.
TEST(Times, DoNotContradictARateIfRounded) {
  for (const double rate_hz : {25600., 25000., 9700., 12000., 952.}) {
    for (const double resolution_s : {1e-6, 1e-5, 1e-4, 1e-3}) {
      const Times times = named(times_without(0, 0, resolution_s, rate_hz), 1);
      EXPECT_FALSE(contradicting_rate(times, rate_hz)) << rate_hz << " " << resolution_s;
    }
  }
  EXPECT_TRUE(contradicting_rate(named(times_without(0, 0, 1e-3), 1), 25600));
}

TEST(Times, AreUnevenIfTheyScatterMoreThanRounding) {
  Stream random("steps");
  Numbers uneven;
  double t = 0;
  for (int i = 0; i < 5000; ++i) uneven.push_back(t += random.uniform(0.2, 1.8) / 12000);
  EXPECT_TRUE(named(uneven).is_uneven);
  EXPECT_FALSE(unnamed(uneven).is_uneven);
  EXPECT_TRUE(contradicting_rate(named(uneven, 1), 48000));
  EXPECT_FALSE(contradicting_rate(named(uneven, 1), 12000));
  for (const double rate_hz : {25600., 12000., 952., 400.}) {
    for (const double resolution_s : {1e-6, 1e-5, 1e-4, 1e-3}) {
      EXPECT_FALSE(named(times_without(0, 0, resolution_s, rate_hz)).is_uneven)
          << rate_hz << " " << resolution_s;
    }
  }
}

/// Spreadsheets store dates in days.
TEST(Times, MayBeDays) {
  Numbers days = times_without(0, 0, 1e-5);
  for (double& time : days) time = 45000.5 + time / 86400;
  EXPECT_FALSE(contradicting_rate(named(days), 12000));
  EXPECT_TRUE(contradicting_rate(named(days), 25600));
}

TEST(Times, DoNotContradictARateIfTheyMayCountSamples) {
  Numbers count;
  for (int i = 0; i < 5000; ++i) count.push_back(i);
  EXPECT_FALSE(contradicting_rate(unnamed(count), 12000));
  EXPECT_FALSE(contradicting_rate(named(count), 12000));
  EXPECT_TRUE(contradicting_rate(named(count, 1e-3), 12000));
  for (double& number : count) number *= 5;
  EXPECT_FALSE(contradicting_rate(unnamed(count), 12000));
}

std::string table(const std::string& header, double scale, const Numbers& times) {
  std::string text = header;
  for (const double t : times) {
    text += std::to_string(t * scale) + ',' + std::to_string(std::sin(1e4 * t)) + '\n';
  }
  return text;
}

TEST(Times, AreTakenNextToTheSignalInText) {
  const Folder folder;
  const auto file =
      folder.write("run.csv", table("time,acceleration\n", 1, times_without(1000, 40)));
  EXPECT_EQ(signal_here(file, "acceleration").times.missing, 40U);
  EXPECT_EQ(signal_here(file, "2").times.longest_after, 999U);
  EXPECT_EQ(signal_here(file, "1").times.column, 0U) << "that is the signal";
  const Signals both = read_all({file, file}, "2");
  EXPECT_EQ(both.pieces.at(1).times.missing, 40U);
  EXPECT_EQ(both.pieces.at(1).times.column, 1U);
  const auto dates = folder.write("dates.csv", "date,x\n2024-02-24,1\n2024-02-25,2\n");
  EXPECT_EQ(signal_here(dates, "x").times.column, 0U);
}

TEST(Times, AreInTheColumnNamedTime) {
  const Folder folder;
  std::string text = "No.;x;Time\n;g;[ms]\n";
  for (int i = 0; i < 100; ++i) {
    text += std::to_string(i) + ';' + std::to_string(std::sin(i)) + ';' + std::to_string(0.5 * i) +
            '\n';
  }
  const Times times = signal_here(folder.write("run.csv", text), "x").times;
  EXPECT_EQ(times.column, 3U);
  EXPECT_EQ(times.unit_s, 1e-3);
  EXPECT_NEAR(times.step, 0.5, 1e-6);
}

TEST(Times, AreRefusedAtAnotherRateIfTheirUnitIsKnown) {
  const Folder folder;
  const Numbers times = times_without(0, 0);
  const auto file = folder.write("run.csv", table("Time (s),x\n", 1, times));
  EXPECT_ERROR(signal_here(file, "x", 48000), Exit::bad_input,
               "run.csv: is sampled at 12000 Hz by the times in column 1, which step by 8.3333e-05 "
               "s, not at 48000 Hz; correct its sample_rate_hz");
  EXPECT_EQ(signal_here(file, "x", 12000).samples.size(), 5000U);
  EXPECT_EQ(signal_here(file, "x").samples.size(), 5000U);
  const auto ms = folder.write("ms.csv", table("Time,x\n(ms),(g)\n", 1000, times));
  EXPECT_ERROR(signal_here(ms, "x", 12), Exit::bad_input, "is sampled at 12000 Hz");
  EXPECT_EQ(signal_here(ms, "2", 12000).samples.size(), 5000U);
  const auto no_unit = folder.write("t.csv", table("Time,x\n", 1, times));
  EXPECT_EQ(signal_here(no_unit, "x", 48000).samples.size(), 5000U) << "the check warns";
}

}  // namespace
}  // namespace piae::raw
