#include "trend/healthy.hpp"

#include <gtest/gtest.h>

#include "support/errors.hpp"
#include "support/folder.hpp"
#include "trend/healthy_hours.hpp"

namespace piae::trend {
namespace {

/// Returns eight windows whose first two features alternate between 0 and 2, and 0 and 10 dB.
std::vector<Features> alternating() {
  std::vector<Features> windows;
  for (int i = 0; i < 8; ++i) {
    windows.push_back(features_of(i % 2 == 0 ? 3 : 5, i % 2 == 0 ? 0 : 2, i % 2 == 0 ? 0 : 10));
  }
  return windows;
}

// Standard deviations are 1 and 5 times sqrt(8 / 7) = 1.069045.
TEST(Healthy, LimitsAreTheLeastRiseOrTheSpread) {
  const Healthy healthy(alternating(), {});
  EXPECT_NEAR(healthy.limits_db()[0], 6, 1e-12);
  EXPECT_NEAR(healthy.limits_db()[1], 16.035675, 1e-6);
  EXPECT_NEAR(healthy.limits_db()[2], 6, 1e-12);
  const Healthy strict(alternating(), {.least_rise_db = 1, .spreads = 2});
  EXPECT_NEAR(strict.limits_db()[0], 2.138090, 1e-6);
  EXPECT_NEAR(strict.limits_db()[2], 1, 1e-12);
}

TEST(Healthy, RisesAreAboveTheMean) {
  const Healthy healthy(alternating(), {});
  const Features window = features_of(10, 7, 3);
  EXPECT_NEAR(healthy.level_rise_db(window), 6, 1e-12);
  EXPECT_NEAR(healthy.rises_db(window)[0], 6, 1e-12);
  EXPECT_NEAR(healthy.rises_db(window)[1], -2, 1e-12);
  EXPECT_LT(healthy.novelty(alternating()[0]), 1);
  EXPECT_GT(healthy.novelty(window), 1);
}

TEST(Healthy, NeedsEightWindows) {
  std::vector<Features> seven = alternating();
  seven.pop_back();
  EXPECT_ERROR(Healthy(seven, {}), Exit::bad_input, "hold 7 windows");
  EXPECT_ERROR(Healthy({}, {}), Exit::bad_input, "hold 0 windows");
}

class KeptBaseline : public testing::Test {
 protected:
  /// Writes a baseline; `change` may damage its content.
  std::filesystem::path kept(const std::vector<Features>& windows, const FeatureMeter& meter) {
    artefact::Writer writer("baseline");
    write(writer, meter, windows);
    writer.save(folder_ / "baseline.h5", {});
    return folder_ / "baseline.h5";
  }
  Folder folder_;
};

TEST_F(KeptBaseline, IsReadAsWritten) {
  const std::vector<Features> windows = alternating();
  const Baseline baseline =
      read_baseline(artefact::Reader(kept(windows, noise_meter()), "baseline"));
  EXPECT_EQ(baseline.meter.rate_hz(), noise_rate_hz);
  EXPECT_EQ(baseline.meter.length(), noise_length);
  EXPECT_FALSE(baseline.meter.lines().has_value());
  ASSERT_EQ(baseline.windows.size(), windows.size());
  for (std::size_t i = 0; i < windows.size(); ++i) {
    EXPECT_EQ(baseline.windows[i].level_db, windows[i].level_db);
    EXPECT_TRUE((baseline.windows[i].watched_db == windows[i].watched_db).all());
    EXPECT_TRUE((baseline.windows[i].shape_db == windows[i].shape_db).all());
  }
}

TEST_F(KeptBaseline, KeepsTheLines) {
  std::vector<Features> windows = alternating();
  for (Features& window : windows) window.watched_db.conservativeResize(level_features + 3);
  for (Features& window : windows) window.watched_db.tail(3) = 1.5;
  const FeatureMeter meter(25600, 2560, Lines{.orders = {7.4, 7.2, 5.6}, .speed_rpm = 1650});
  const Baseline baseline = read_baseline(artefact::Reader(kept(windows, meter), "baseline"));
  ASSERT_TRUE(baseline.meter.lines().has_value());
  EXPECT_EQ(baseline.meter.lines()->orders, meter.lines()->orders);
  EXPECT_EQ(baseline.meter.lines()->speed_rpm, 1650);
}

TEST_F(KeptBaseline, IsRefusedIfImpossible) {
  std::vector<Features> windows = alternating();
  windows[3].level_db = 1e6;
  EXPECT_ERROR(read_baseline(artefact::Reader(kept(windows, noise_meter()), "baseline")),
               Exit::bad_input, "/level_db");
  windows = alternating();
  windows.pop_back();
  EXPECT_ERROR(read_baseline(artefact::Reader(kept(windows, noise_meter()), "baseline")),
               Exit::bad_input, "has 7 healthy windows");
}

}  // namespace
}  // namespace piae::trend
