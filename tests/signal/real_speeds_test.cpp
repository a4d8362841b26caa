// Estimates the speed of all recordings whose speed is known, if the environment variable DATA_DIR
// is set.
#include <gtest/gtest.h>
#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>

#include "signal/estimated_speeds.hpp"
#include "spectra/shaft_speed.hpp"

namespace piae::signal {
namespace {

namespace fs = std::filesystem;

/// Results for the recordings of one rig: certain and within 0.5 %, not certain, certain and wrong.
struct Estimates {
  int within = 0;
  int uncertain = 0;
  int wrong = 0;
  std::string wrong_ones = {};
};

struct Known {
  fs::path file;
  double true_rpm = 0;
  double given_rpm = 0;
};

void estimate(const Known& known, const Record& record, double rate_hz, Estimates& estimates) {
  const auto shaft = spectra::estimate_shaft_speed(
      longest_piece(record.signal, record.piece_lengths()), rate_hz, known.given_rpm);
  if (!shaft || !shaft->is_certain()) {
    ++estimates.uncertain;
  } else if (std::abs(shaft->rpm / known.true_rpm - 1) <= 0.005) {
    ++estimates.within;
  } else {
    ++estimates.wrong;
    estimates.wrong_ones +=
        fmt::format("  {}: {:.1f} of {:g} rpm\n", known.file.string(), shaft->rpm, known.true_rpm);
  }
}

class KnownSpeeds : public testing::Test {
 protected:
  /// Estimates the speeds of a data set; `known` returns the speeds of a record, or nothing.
  void try_on(const std::string& dataset,
              const std::function<std::optional<Known>(const RecordSource&)>& known,
              const std::string& row) {
    const char* const folder = std::getenv("DATA_DIR");
    if (folder == nullptr) GTEST_SKIP() << "DATA_DIR is not set";
    const Description description =
        read_description(fs::path(PIAE_SOURCE) / "pipeline/datasets" / (dataset + ".toml"));
    if (!fs::exists(fs::path(folder) / description.records.front().file_text())) {
      GTEST_SKIP() << "DATA_DIR does not have " << dataset;
    }
    RecordReader reader(description, folder);
    for (const RecordSource& source : description.records) {
      const auto speeds = known(source);
      if (speeds) estimate(*speeds, reader.read(source), description.info.sample_rate_hz, found_);
    }
    std::cout << fmt::format("{:<42} {:>3} within 0.5 %, {:>2} uncertain, {:>2} wrong\n{}", row,
                             found_.within, found_.uncertain, found_.wrong, found_.wrong_ones);
  }
  Estimates found_;
};

bool is_of_unknown_speed(const RecordSource& source) {
  return source.file_text().starts_with("cwru/300");  // 3001 to 3008
}

std::optional<Known> of_cwru(const RecordSource& source, double given_rpm) {
  if (is_of_unknown_speed(source)) return std::nullopt;
  return Known{source.file_text(), source.shaft_speed_rpm, given_rpm};
}

/// The field of 158.mat says 1773 rpm; its shaft and BPFO (107.8 Hz) say 1797, the speed of 0 hp.
TEST_F(KnownSpeeds, OfCwruAreFoundFromTheNominalOne) {
  try_on(
      "cwru-blind", [](const RecordSource& s) { return of_cwru(s, 1797); },
      "CWRU by its RPM fields, given 1797");
  if (IsSkipped()) return;
  EXPECT_GE(found_.within, 52);
  EXPECT_EQ(found_.wrong_ones, "  cwru/158.mat: 1796.4 of 1773 rpm\n");
}

TEST_F(KnownSpeeds, OfCwruAreFoundFromFivePercentBelowAndAbove) {
  for (const double factor : {0.95, 1.05}) {
    found_ = {};
    try_on(
        "cwru-blind", [&](const RecordSource& s) { return of_cwru(s, factor * s.shaft_speed_rpm); },
        fmt::format("CWRU by its RPM fields, given {:+.0f} %", 100 * (factor - 1)));
    if (IsSkipped()) return;
    EXPECT_GE(found_.within, 51);
    EXPECT_LE(found_.wrong, 1);
  }
}

/// The rig turns up to 1 % faster than its nominal speeds. The lines of the bearing say how fast
/// (IR2, IR5, IR8, OR2, OR5 and OR8), measured by six harmonics of the envelope spectrum.
std::optional<Known> of_hit_sm(const RecordSource& source, double factor) {
  static const std::map<std::string, double> by_lines{
      {"IR2_600", 604.7},   {"IR5_600", 602.1},   {"IR8_600", 605.6},   {"OR2_600", 601.5},
      {"OR5_600", 604.7},   {"OR8_600", 601.5},   {"IR2_900", 902.1},   {"IR5_900", 898.8},
      {"IR8_900", 903.5},   {"OR2_900", 899.7},   {"OR5_900", 901.5},   {"OR8_900", 900.9},
      {"IR2_1200", 1202.9}, {"IR5_1200", 1200.6}, {"IR8_1200", 1203.5}, {"OR2_1200", 1200.0},
      {"OR5_1200", 1200.0}, {"OR8_1200", 1202.3}};
  const auto known = by_lines.find(fs::path(source.file_text()).stem().string());
  if (known == by_lines.end()) return std::nullopt;
  return Known{source.file_text(), known->second, factor * source.shaft_speed_rpm};
}

TEST_F(KnownSpeeds, OfHitSmAreFoundOrNotCertain) {
  for (const double factor : {0.95, 1.0, 1.05}) {
    found_ = {};
    try_on(
        "hit-sm-speeds", [&](const RecordSource& s) { return of_hit_sm(s, factor); },
        fmt::format("HIT-SM by its fault lines, given {:+.0f} %", 100 * (factor - 1)));
    if (IsSkipped()) return;
    EXPECT_GE(found_.within, 15);
    EXPECT_EQ(found_.wrong, 0);
  }
}

/// N at 1000 rpm and B at 1400 rpm are known to 5 % only.
std::optional<Known> of_uestc(const RecordSource& source) {
  const std::string stem = fs::path(source.file_text()).stem().string();
  if (stem.starts_with("N_1000") || stem.starts_with("B_1400")) return std::nullopt;
  return Known{source.file_text(), source.shaft_speed_rpm, std::stod(stem.substr(2))};
}

TEST_F(KnownSpeeds, OfUestcAreFoundFromTheNominalOnes) {
  try_on("uestc-true-speeds", of_uestc, "UESTC, nominal");
  if (IsSkipped()) return;
  EXPECT_GE(found_.within, 22);
  EXPECT_EQ(found_.wrong, 0);
}

}  // namespace
}  // namespace piae::signal
