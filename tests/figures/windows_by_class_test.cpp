#include "figures/windows_by_class.hpp"

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

/// Returns one window of each fault class, in g: tones of 3000 Hz with these amplitudes.
signal::WindowSet tones(double of_inner, double of_outer) {
  signal::WindowSet set;
  set.info = three_classes("cwru");
  set.info.unit_m_per_s2 = 10;
  set.length = 1024;
  set.labels = {1, 2};
  for (const double amplitude : {of_inner, of_outer}) {
    for (int i = 0; i < 1024; ++i) {
      set.samples.push_back(static_cast<float>(amplitude * std::cos(std::numbers::pi * i / 2)));
    }
  }
  return set;
}

class WindowsByClass : public StoredRun {
 protected:
  static void save(const signal::WindowSet& windows, const std::string& role,
                   const std::filesystem::path& path) {
    artefact::Writer writer("windows");
    signal::write(writer, windows);
    writer.attribute("/", "role", role);
    writer.save(path, {"test", "", {}});
  }
  void save_all() const {
    save(tones(1, 2), "D", layout_.real_windows(0));
    save(tones(0.1, 20), "E", layout_.generated_windows("vae", 0));
  }

  Source source_{layout_, grid_, {}};
};

TEST_F(WindowsByClass, HasAPictureOfEachFaultClass) {
  save_all();
  const std::vector<Picture> pictures = windows_by_class(source_);
  ASSERT_EQ(pictures.size(), 2U);
  EXPECT_EQ(pictures[0].part, "IR");
  EXPECT_EQ(pictures[1].part, "OR");
}

TEST_F(WindowsByClass, ShowsRealAndGeneratedWindowsInMetresPerSecondSquared) {
  save_all();
  const std::vector<Picture> pictures = windows_by_class(source_);
  const CsvRows inner(pictures[0].numbers);
  EXPECT_THAT(inner.header(), testing::ElementsAre("panel", "what", "x", "y", "real", "vae"));
  const auto highest = inner.where({{"panel", "waveform"}, {"what", "high"}});
  ASSERT_EQ(highest.size(), 128U);
  EXPECT_EQ(inner.where({{"panel", "unit"}}).at(0).at("what"), "m/s2");  // converted from g
  EXPECT_EQ(highest[7].at("real"), "10");
  EXPECT_EQ(highest[7].at("vae"), "1");
  const CsvRows outer(pictures[1].numbers);
  EXPECT_EQ(outer.where({{"panel", "waveform"}, {"what", "low"}})[7].at("vae"), "-200");
}

/// The tone lies on bin 256 of 512, and on bin 8 of the spectrogram's segments.
TEST_F(WindowsByClass, ShowsTheirLevels) {
  save_all();
  const CsvRows rows(windows_by_class(source_)[0].numbers);
  const auto spectrum = rows.where({{"panel", "spectrum"}, {"x", "2982"}});  // bins 253 to 256
  ASSERT_EQ(spectrum.size(), 1U);
  EXPECT_EQ(spectrum[0].at("real"), "20.0");
  EXPECT_EQ(spectrum[0].at("vae"), "0.0");
  const auto cells = rows.where({{"panel", "spectrogram"}, {"x", "4"}, {"y", "3000"}});
  ASSERT_EQ(cells.size(), 1U);
  EXPECT_EQ(cells[0].at("real"), "20");
  EXPECT_EQ(rows.where({{"panel", "spectrogram"}}).size(), 63U * 16);
}

/// A 6205 at 1800 rpm: BPFO 107.56, BPFI 162.44, 2 BSF 141.22 Hz (9 balls of 7.94 mm on 39 mm).
TEST_F(WindowsByClass, NamesTheFaultLinesAndTheSidebandsOfTheClass) {
  save_all();
  const CsvRows rows(windows_by_class(source_)[0].numbers);
  const auto own = rows.where({{"panel", "own-line"}});
  ASSERT_EQ(own.size(), 3U);
  EXPECT_EQ(own[0].at("what"), "BPFI");
  EXPECT_EQ(own[0].at("x"), "162.5");
  EXPECT_EQ(own[2].at("x"), "487.5");
  EXPECT_EQ(own[2].at("y"), "3");
  const auto sidebands = rows.where({{"panel", "sideband"}});
  ASSERT_EQ(sidebands.size(), 6U);
  EXPECT_EQ(sidebands[0].at("x"), "132.5");
  EXPECT_EQ(sidebands[1].at("x"), "192.5");
  EXPECT_EQ(rows.where({{"panel", "line"}, {"what", "BPFO"}})[0].at("x"), "107.5");
  EXPECT_EQ(rows.where({{"panel", "line"}, {"what", "2BSF"}})[1].at("x"), "282.5");
}

TEST_F(WindowsByClass, NamesAMissingFile) {
  save(tones(1, 2), "D", layout_.real_windows(0));
  EXPECT_ERROR(windows_by_class(source_), Exit::input_missing,
               layout_.generated_windows("vae", 0).string());
}

TEST_F(WindowsByClass, RefusesWindowsOfAnotherRole) {
  save(tones(1, 2), "C", layout_.real_windows(0));
  EXPECT_ERROR(windows_by_class(source_), Exit::bad_input, layout_.real_windows(0).string());
}

TEST_F(WindowsByClass, RefusesWindowsOfAnotherLength) {
  save_all();
  signal::WindowSet shorter = tones(1, 1);
  shorter.length = 512;
  shorter.labels = {1, 2, 1, 2};
  save(shorter, "E", layout_.generated_windows("vae", 0));
  EXPECT_ERROR(windows_by_class(source_), Exit::bad_input, "D.h5");
}

}  // namespace
}  // namespace piae::figures
