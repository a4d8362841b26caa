#include "figures/other_condition.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "figures/csv_rows.hpp"
#include "signal/roles.hpp"
#include "signal/window_set.hpp"
#include "support/errors.hpp"
#include "support/stored_run.hpp"

namespace piae::figures {
namespace {

/// A window with a tone on a bin of 1024 samples, or of 512 at 12 kHz.
struct ToneWindow {
  Label label = 1;
  int condition = signal::every_condition;
  double amplitude = 1;
  int bin = 256;
};

/// Faults of a 6205, known at 1800 rpm and tested at 1200 rpm; some tests add other conditions.
class OtherCondition : public StoredRun {
 protected:
  OtherCondition() {
    info_.conditions = {
        {.name = "1800 rpm", .shaft_speed_rpm = 1800, .known = true, .test = false},
        {.name = "1200 rpm", .shaft_speed_rpm = 1200, .known = false, .test = true}};
  }

  void save(const std::vector<ToneWindow>& tones, const std::string& role,
            const std::filesystem::path& path) const {
    signal::WindowSet set;
    set.info = info_;
    set.length = 1024;
    for (const ToneWindow& tone : tones) {
      set.labels.push_back(tone.label);
      for (int i = 0; i < 1024; ++i) {
        const double turns = tone.bin * i / 1024.0;
        set.samples.push_back(
            static_cast<float>(tone.amplitude * std::cos(2 * std::numbers::pi * turns)));
      }
      if (tone.condition == signal::every_condition) continue;
      set.condition.push_back(tone.condition);
      set.shaft_speed_rpm.push_back(info_.speed_rpm(tone.condition));
    }
    artefact::Writer writer("windows");
    signal::write(writer, set);
    writer.attribute("/", "role", role);
    writer.save(path, {"test", "", {}});
  }
  void save_known(const std::vector<ToneWindow>& tones) const {
    save(tones, "C", layout_.known_windows(0));
  }
  void save_real(const std::vector<ToneWindow>& tones) const {
    save(tones, "D", layout_.real_windows(0));
  }
  void save_generated(const std::string& method, const std::vector<ToneWindow>& tones) const {
    save(tones, "E", layout_.generated_windows(method, 0));
  }
  /// Returns a window of each class in a condition.
  static std::vector<ToneWindow> of_both(int condition, double amplitude = 1) {
    return {{1, condition, amplitude}, {2, condition, amplitude}};
  }
  void save_all() const {
    save_known(of_both(0, 2));
    save_real(of_both(1, 500));
    save_generated("strike-twin", of_both(1, 0.1));
  }

  [[nodiscard]] std::vector<Picture> pictures(const std::string& methods = "none strike-twin") {
    Source source(layout_, grid(methods, "100to1 2to1", "0"), {});
    return other_condition(source);
  }

  signal::DatasetInfo info_ = three_classes("cwru");
};

TEST_F(OtherCondition, HasAPictureOfEachFaultClass) {
  save_all();
  const std::vector<Picture> both = pictures();
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[0].part, "IR");
  EXPECT_EQ(both[1].part, "OR");
}

TEST_F(OtherCondition, ShowsGeneratedWindowsBetweenKnownAndRealOnes) {
  save_all();
  save_generated("shift", of_both(signal::every_condition));
  save_generated("vae", of_both(signal::every_condition));
  save_generated("resample", of_both(1));
  const CsvRows rows(pictures("none vae strike-twin resample shift")[0].numbers);
  EXPECT_THAT(rows.header(), testing::ElementsAre("panel", "what", "x", "y", "known", "shift",
                                                  "resample", "strike-twin", "real"));
}

TEST_F(OtherCondition, NamesTheSpeedAndTheConditionOfEachRow) {
  save_all();
  save_generated("shift", of_both(signal::every_condition));
  const CsvRows rows(pictures("none shift strike-twin")[1].numbers);
  const auto of_row = [&](const std::string& name) {
    const CsvRows::Row row = rows.where({{"panel", "row"}, {"what", name}}).at(0);
    return row.at("x") + ", " + row.at("y");
  };
  EXPECT_EQ(of_row("known"), "1800, 1800 rpm");
  EXPECT_EQ(of_row("shift"), "1200, ");
  EXPECT_EQ(of_row("strike-twin"), "1200, 1200 rpm");
  EXPECT_EQ(of_row("real"), "1200, 1200 rpm");
}

/// 9 balls of 7.94 mm on 39 mm, a ratio of 0.2036: at 30 turns per second BPFI is 9 * 15 * 1.2036 =
/// 162.5 Hz, and BPFO 9 * 15 * 0.7964 = 107.5 Hz; at 20 turns 108.3 and 71.68 Hz.
TEST_F(OtherCondition, HasTheLinesOfTheClassAtTheSpeedOfEachRow) {
  save_all();
  const std::vector<Picture> both = pictures();
  const auto inner = CsvRows(both[0].numbers).where({{"panel", "line"}});
  ASSERT_EQ(inner.size(), 5U);
  EXPECT_EQ(inner[0].at("what"), "BPFI");
  EXPECT_EQ(inner[0].at("y"), "1");
  EXPECT_EQ(inner[0].at("known"), "162.5");
  EXPECT_EQ(inner[0].at("strike-twin"), "108.3");
  EXPECT_EQ(inner[0].at("real"), "108.3");
  EXPECT_EQ(inner[2].at("known"), "487.5");
  EXPECT_EQ(inner[2].at("real"), "325");
  const auto outer = CsvRows(both[1].numbers).where({{"panel", "line"}});
  EXPECT_EQ(outer[0].at("what"), "BPFO");
  EXPECT_EQ(outer[0].at("known"), "107.5");
  EXPECT_EQ(outer[0].at("real"), "71.68");
}

/// The axis ends at 547 Hz, two turns of the faster shaft above its third BPFI.
TEST_F(OtherCondition, HasTheLinesWithinTheAxis) {
  save_all();
  const CsvRows rows(pictures()[0].numbers);
  const double last_hz = std::stod(rows.where({{"panel", "envelope"}}).back().at("x"));
  EXPECT_NEAR(last_hz, 547, 12000.0 / 1024);
  const auto lines = rows.where({{"panel", "line"}});
  EXPECT_EQ(lines[3].at("known"), "");      // 650 Hz
  EXPECT_EQ(lines[4].at("real"), "541.6");  // the sixth would lie at 650 Hz
}

TEST_F(OtherCondition, ScalesWindowsByTheirRms) {
  save_all();  // amplitudes of 2, 0.1 and 500
  const CsvRows rows(pictures()[0].numbers);
  const auto highest = rows.where({{"panel", "waveform"}, {"what", "high"}});
  const auto spectrum = rows.where({{"panel", "spectrum"}, {"x", "2982"}});  // bins 253 to 256
  ASSERT_EQ(spectrum.size(), 1U);
  for (const std::string name : {"known", "strike-twin", "real"}) {
    EXPECT_EQ(highest[7].at(name), "1.414");  // for a tone with an RMS of 1
    EXPECT_EQ(spectrum[0].at(name), "3.0");
  }
}

/// Two tones, each in one window, each have half their power in the mean: 3 dB less.
TEST_F(OtherCondition, GivesEachWindowTheSameWeightInASpectrum) {
  save_all();
  save_real({{1, 1, 1000, 256}, {1, 1, 0.001, 128}, {2, 1}});
  const CsvRows rows(pictures()[0].numbers);
  for (const std::string hz : {"2982", "1482"}) {
    const auto tone = rows.where({{"panel", "spectrum"}, {"x", hz}}).at(0);
    EXPECT_NEAR(std::stod(tone.at("real")), 0, 0.05);
  }
}

TEST_F(OtherCondition, HasARowForEachKnownConditionOfTheClass) {
  info_.conditions.push_back(
      {.name = "600 rpm", .shaft_speed_rpm = 600, .known = true, .test = false});
  save_all();
  save_known({{1, 0}, {1, 2}, {2, 2}});
  const std::vector<Picture> both = pictures();
  const CsvRows inner(both[0].numbers);
  EXPECT_THAT(inner.header(), testing::ElementsAre("panel", "what", "x", "y", "known", "known-2",
                                                   "strike-twin", "real"));
  EXPECT_EQ(inner.where({{"panel", "row"}, {"what", "known-2"}}).at(0).at("y"), "600 rpm");
  const CsvRows outer(both[1].numbers);
  EXPECT_EQ(outer.header()[5], "strike-twin");
  EXPECT_EQ(outer.where({{"panel", "row"}, {"what", "known"}}).at(0).at("y"), "600 rpm");
}

/// At 600 rpm BPFI is 54.16 Hz. Windows of 1200 rpm have other tones.
TEST_F(OtherCondition, ShowsTheTestedConditionFarthestFromTheKnownOnes) {
  info_.conditions.push_back(
      {.name = "600 rpm", .shaft_speed_rpm = 600, .known = false, .test = true});
  save_known(of_both(0));
  save_real({{1, 1, 1, 128}, {1, 2}, {2, 1}});
  save_generated("strike-twin", {{1, 1, 1, 128}, {1, 2}, {2, 1}});
  const std::vector<Picture> both = pictures();
  const CsvRows inner(both[0].numbers);
  EXPECT_EQ(inner.where({{"panel", "row"}, {"what", "real"}}).at(0).at("y"), "600 rpm");
  EXPECT_EQ(inner.where({{"panel", "line"}}).at(0).at("strike-twin"), "54.16");
  const auto tone = inner.where({{"panel", "spectrum"}, {"x", "2982"}}).at(0);
  EXPECT_EQ(tone.at("real"), "3.0");
  EXPECT_EQ(tone.at("strike-twin"), "3.0");
  // A class without windows there is shown in another condition.
  const CsvRows outer(both[1].numbers);
  EXPECT_EQ(outer.where({{"panel", "row"}, {"what", "real"}}).at(0).at("y"), "1200 rpm");
}

TEST_F(OtherCondition, IsLeftOutIfTestedAndKnownConditionsAreTheSame) {
  info_.conditions.clear();
  save_real(of_both(signal::every_condition));
  EXPECT_THROW(static_cast<void>(pictures()), LeftOut);
  info_.conditions = {{.name = "1800 rpm", .shaft_speed_rpm = 1800},
                      {.name = "1200 rpm", .shaft_speed_rpm = 1200}};
  save_real(of_both(1));
  EXPECT_THROW(static_cast<void>(pictures()), LeftOut);
}

TEST_F(OtherCondition, NamesAMissingFile) {
  save_real(of_both(1));
  EXPECT_ERROR(pictures(), Exit::input_missing, layout_.known_windows(0).string());
  save_known(of_both(0));
  EXPECT_ERROR(pictures(), Exit::input_missing,
               layout_.generated_windows("strike-twin", 0).string());
}

TEST_F(OtherCondition, RefusesWindowsOfOtherConditions) {
  save_all();
  info_.conditions[0].name = "3600 rpm";
  save_known(of_both(0));
  EXPECT_ERROR(pictures(), Exit::bad_input, layout_.known_windows(0).string());
}

TEST_F(OtherCondition, RefusesKnownWindowsOfTheTestedCondition) {
  save_all();
  save_known(of_both(1));
  EXPECT_ERROR(pictures(), Exit::bad_input, layout_.known_windows(0).string());
}

}  // namespace
}  // namespace piae::figures
