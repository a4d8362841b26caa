// A bearing on a shaft whose speed drifts by 20 %, from the files to the windows.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "signal/estimated_speeds.hpp"
#include "signal/ingest.hpp"
#include "signal/split.hpp"
#include "support/description_text.hpp"
#include "support/drifting_shaft.hpp"
#include "support/folder.hpp"
#include "support/turning_shaft.hpp"

namespace piae::signal {
namespace {

constexpr double rate_of_drift_hz = 12000;
constexpr double bpfo = 3.585;
constexpr std::size_t length_of_drift = 16384;

/// Returns the order, from 3 to 4.2, at which the squared window is highest, by its Fourier sum.
double highest_order(std::span<const float> window, double rpm) {
  constexpr std::size_t together = 16;
  std::vector<double> power(window.size() / together);
  for (std::size_t i = 0; i < power.size() * together; ++i) {
    power[i / together] += std::pow(window[i], 2);
  }
  double mean = 0;
  for (const double p : power) mean += p / static_cast<double>(power.size());
  double best = 0;
  double highest = 0;
  for (double order = 3; order < 4.2; order += 0.005) {
    const double step = 2 * std::numbers::pi * order * rpm / 60 * together / rate_of_drift_hz;
    std::complex<double> sum;
    for (std::size_t i = 0; i < power.size(); ++i) {
      const double hann = 1 - std::cos(2 * std::numbers::pi * (static_cast<double>(i) + 0.5) /
                                       static_cast<double>(power.size()));
      sum += hann * (power[i] - mean) * std::polar(1.0, -step * static_cast<double>(i));
    }
    if (std::abs(sum) < highest) continue;
    highest = std::abs(sum);
    best = order;
  }
  return best;
}

class DriftingSpeed : public testing::Test {
 protected:
  DriftingSpeed() {
    folder_.write("healthy.csv", column_of(shaft_.impacts(bpfo, 0, rate_of_drift_hz, 1)));
    folder_.write("outer.csv", column_of(shaft_.impacts(bpfo, 20, rate_of_drift_hz, 2)));
    folder_.write("tacho.csv", column_of(shaft_.times_s(1)));
  }
  [[nodiscard]] Description description(const std::string& speed) const {
    const auto record = [](const std::string& name, const std::string& label) {
      return "[[record]]\nclass = \"" + label + "\"\nfile = \"" + name +
             ".csv\"\nvariable = \"1\"\nsample_rate_hz = 12000\n";
    };
    return read_description(folder_.write(
        "rig.toml", described_bearing("rig") + described_normal + described_or021 +
                        record("healthy", "Normal") + "shaft_speed_rpm = 1500\n" +
                        record("outer", "OR021") + "shaft_speed_rpm = " + speed + "\n"));
  }
  /// Returns test windows, as split makes them from records.h5.
  [[nodiscard]] WindowSet windows(const std::string& speed) const {
    Description described = description(speed);
    (void)use_speeds_of_signals(described, folder_.path(), [] {});
    artefact::Writer writer("records");
    RecordingsWriter recordings(writer, described.info);
    ingest(described, folder_.path(), [&](const Record& record) { recordings.add(record); });
    recordings.finish();
    writer.save(folder_ / "records.h5", {});
    const artefact::Reader reader(folder_ / "records.h5", "records");
    has_speeds_ = reader.has("/speeds/OR021");
    return split(read_recordings(reader), {.window = length_of_drift,
                                           .max_stride = 4096,
                                           .windows_per_class = 40,
                                           .test_per_class = 20,
                                           .known_per_class = 5})
        .of(Role::test);
  }
  /// Returns the share of the windows of the fault that show its line within 0.5 %.
  static double share_right(const WindowSet& windows) {
    double right = 0;
    for (const std::size_t i : windows.indices_of(1)) {
      const double order = highest_order(windows.window(i), windows.speed_rpm(i));
      right += std::abs(order / bpfo - 1) <= 0.005 ? 1 : 0;
    }
    return right / static_cast<double>(windows.count_of(1));
  }
  const DriftingShaft shaft_;
  const Folder folder_;
  mutable bool has_speeds_ = false;
};

TEST_F(DriftingSpeed, OfEachWindowShowsTheLine) {
  const WindowSet set = windows(R"({ file = "tacho.csv", variable = "1" })");
  EXPECT_TRUE(has_speeds_);
  for (const std::size_t i : set.indices_of(1)) {
    const double middle_s =
        (static_cast<double>(set.first_sample[i]) + length_of_drift / 2.0) / rate_of_drift_hz;
    EXPECT_NEAR(set.speed_rpm(i) / shaft_.rpm_at(middle_s), 1, 1e-3);
  }
  for (const std::size_t i : set.indices_of(0)) EXPECT_EQ(set.speed_rpm(i), 1500);
  EXPECT_EQ(share_right(set), 1);
}

TEST_F(DriftingSpeed, OfTheWholeRecordDoesNot) {
  const WindowSet set = windows("1500");
  EXPECT_FALSE(has_speeds_);
  EXPECT_LE(share_right(set), 0.2);
}

}  // namespace
}  // namespace piae::signal
