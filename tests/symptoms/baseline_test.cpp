#include "symptoms/baseline.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.hpp"
#include "spectra/bands.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"
#include "support/three_classes.hpp"

namespace piae::symptoms {
namespace {

/// Returns measures in which every line has this height, with a matching spectrum.
Measures measures_of(double height) {
  Measures measures;
  measures.lines.fill(height);
  measures.shape_db = Eigen::Array3d(height, -height, std::sin(height));
  measures.levels_db = Eigen::Array2d(height, 2 * height);
  return measures;
}

/// Healthy windows at these speeds; the i-th has height i + 1.
struct Healthy {
  explicit Healthy(const std::vector<double>& speeds_rpm) {
    windows.info = three_classes();
    windows.length = 1;
    windows.samples.resize(speeds_rpm.size());
    windows.labels.resize(speeds_rpm.size());
    windows.condition.resize(speeds_rpm.size());
    windows.shaft_speed_rpm = speeds_rpm;
    for (std::size_t i = 0; i < speeds_rpm.size(); ++i) {
      measures.push_back(measures_of(static_cast<double>(i) + 1));
    }
  }
  signal::WindowSet windows;
  std::vector<Measures> measures;
};

std::vector<double> eight_of_each(const std::vector<double>& speeds_rpm) {
  std::vector<double> all;
  for (const double speed : speeds_rpm) all.insert(all.end(), 8, speed);
  return all;
}

// 1 .. 8 have the mean 4.5 and the variance 63 / 12 = 5.25.
TEST(Baseline, CountsDeviationsOfHealthyWindows) {
  const Healthy healthy(eight_of_each({1800}));
  Baselines baselines(healthy.windows, healthy.measures);
  const Baseline& baseline = baselines.at(1800);
  EXPECT_NEAR(baseline.excesses(measures_of(10))[1], 5.5 / std::sqrt(5.25), 1e-12);
  EXPECT_NEAR(baseline.rise_db(measures_of(10))[0], 5.5, 1e-12);
  EXPECT_NEAR(baseline.rise_db(measures_of(10))[1], 11, 1e-12);
}

// 9 .. 16 have the mean 12.5.
TEST(Baselines, UseWindowsOfTheNearestSpeed) {
  const Healthy healthy(eight_of_each({1000, 2000}));
  Baselines baselines(healthy.windows, healthy.measures);
  const auto excess = [&](double speed_rpm) {
    return baselines.at(speed_rpm).excesses(measures_of(13))[0];
  };
  EXPECT_NEAR(excess(1000), 8.5 / std::sqrt(5.25), 1e-12);
  EXPECT_NEAR(excess(1019), 8.5 / std::sqrt(5.25), 1e-12);
  EXPECT_NEAR(excess(1400), 8.5 / std::sqrt(5.25), 1e-12);
  EXPECT_NEAR(excess(1430), 0.5 / std::sqrt(5.25), 1e-12);
  EXPECT_NEAR(excess(1970), 0.5 / std::sqrt(5.25), 1e-12);
}

// The mean levels are 4.5 and 9. At twice the speed the first moves beyond the second, so its
// change is 2 dB and that of the second nearly 4.5 - 9.
TEST(Baselines, AllowForAnotherSpeed) {
  const Healthy healthy(eight_of_each({1000}));
  Baselines baselines(healthy.windows, healthy.measures);
  const double novel = baselines.at(1000).novelty().of(measures_of(20).shape_db);
  EXPECT_GT(novel, 1);
  EXPECT_LT(baselines.at(2000).novelty().of(measures_of(20).shape_db), 0.7 * novel);
  EXPECT_EQ(baselines.at(1019).novelty().of(measures_of(20).shape_db), novel);
  EXPECT_NEAR(baselines.at(1000).rise_db(measures_of(10))[0], 5.5, 1e-12);
  EXPECT_NEAR(baselines.at(2000).rise_db(measures_of(10))[0], 3.5, 0.02);
  EXPECT_NEAR(baselines.at(500).rise_db(measures_of(3.5))[0], 0, 1e-12);
  EXPECT_NEAR(baselines.at(2000).rise_db(measures_of(0))[0], -2.5, 0.02);
}

// Seven windows of a speed are too few.
TEST(Baselines, UseAnotherSpeedIfFewHaveTheirOwn) {
  std::vector<double> speeds = eight_of_each({1000});
  speeds.insert(speeds.end(), 7, 2000);
  const Healthy healthy(speeds);
  Baselines baselines(healthy.windows, healthy.measures);
  EXPECT_EQ(&baselines.at(2000), &baselines.at(2001));
  EXPECT_NEAR(baselines.at(2000).excesses(measures_of(8.5))[0], 4 / std::sqrt(5.25), 1e-12);
  EXPECT_EQ(baselines.left_out(14), baselines.at(2000).novelty().of(measures_of(15).shape_db));
}

// 1 .. 8 at eight speeds have the mean 4.5.
TEST(Baselines, UseAllWindowsIfFewHaveAnySpeed) {
  const Healthy healthy({1000, 1100, 1200, 1300, 1400, 1500, 1600, 1700});
  Baselines baselines(healthy.windows, healthy.measures);
  EXPECT_NEAR(baselines.at(1350).excesses(measures_of(10))[0], 5.5 / std::sqrt(5.25), 1e-12);
}

TEST(Baselines, LeaveOutBlocksByTimeNotByOrder) {
  const Healthy sorted(std::vector<double>(8, 1800));
  Healthy mixed = sorted;
  mixed.windows.record_names = {"healthy"};
  mixed.windows.record.assign(8, 0);
  for (std::size_t i = 0; i < 8; ++i) {
    const std::size_t place = 5 * i % 8;
    mixed.windows.first_sample.push_back(static_cast<std::int64_t>(place));
    mixed.measures[i] = sorted.measures[place];
  }
  Baselines of_sorted(sorted.windows, sorted.measures);
  Baselines of_mixed(mixed.windows, mixed.measures);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(of_mixed.left_out(i), of_sorted.left_out(5 * i % 8)) << i;
    EXPECT_EQ(of_sorted.left_out(i),
              of_sorted.at(1800).novelty().of_healthy()[static_cast<Eigen::Index>(i)]);
  }
}

TEST(Baselines, NeedEightHealthyWindows) {
  const Healthy healthy(std::vector<double>(7, 1800));
  EXPECT_ERROR(Baselines(healthy.windows, healthy.measures), Exit::bad_input,
               "7 healthy windows are too few for a baseline; use 8 or more");
}

TEST(Baselines, UseHealthyWindowsOnly) {
  Healthy healthy(std::vector<double>(9, 1800));
  healthy.windows.labels.back() = 1;
  Baselines baselines(healthy.windows, healthy.measures);
  EXPECT_NEAR(baselines.at(1800).rise_db(measures_of(5.5))[0], 1, 1e-12);
}

/// Returns healthy windows with random numbers in all bands.
Healthy with_all_bands(const std::vector<double>& speeds_rpm) {
  Healthy healthy(speeds_rpm);
  Stream stream("bands");
  const auto random_bands = [&](std::size_t count) {
    Eigen::ArrayXd bands(count);
    for (double& band : bands) band = stream.normal(0, 3);
    return bands;
  };
  for (Measures& measures : healthy.measures) {
    for (double& line : measures.lines) line = stream.normal(0, 1);
    measures.shape_db = random_bands(spectra::spectral_shape_bands);
    measures.levels_db = random_bands(spectra::narrow_bands(12000).size());
  }
  return healthy;
}

class StoredBaselines : public testing::Test {
 protected:
  [[nodiscard]] artefact::Reader written(const Healthy& healthy) const {
    artefact::Writer writer("baselines");
    Baselines(healthy.windows, healthy.measures).write(writer, "/some");
    writer.save(folder_ / "baselines.h5", {"test", "", {}});
    return {folder_ / "baselines.h5", "baselines"};
  }
  const Folder folder_;
};

TEST_F(StoredBaselines, CompareAsBefore) {
  const Healthy healthy = with_all_bands(eight_of_each({1000, 2000}));
  Baselines before(healthy.windows, healthy.measures);
  Baselines after = Baselines::read(written(healthy), "/some", 12000);
  const Measures measured = with_all_bands({1000}).measures.front();
  for (const double speed_rpm : {1000.0, 1500.0, 2000.0}) {
    EXPECT_EQ(after.at(speed_rpm).excesses(measured), before.at(speed_rpm).excesses(measured));
    EXPECT_TRUE(
        (after.at(speed_rpm).rise_db(measured) == before.at(speed_rpm).rise_db(measured)).all());
    EXPECT_EQ(after.at(speed_rpm).novelty().of(measured.shape_db),
              before.at(speed_rpm).novelty().of(measured.shape_db));
  }
  EXPECT_NE(after.at(1000).excesses(measured), after.at(2000).excesses(measured));
}

TEST_F(StoredBaselines, NeedTheSameBands) {
  const artefact::Reader reader = written(with_all_bands(eight_of_each({1000})));
  // There are nine narrow bands at 12 kHz, and fewer at 6 kHz.
  EXPECT_ERROR(Baselines::read(reader, "/some", 6000), Exit::bad_input, "/some/levels_db");
  EXPECT_ERROR(Baselines::read(reader, "/other", 12000), Exit::bad_input, "/other/speed_rpm");
}

TEST_F(StoredBaselines, NeedEightWindowsAndPossibleSpeeds) {
  for (const auto& [speeds, what] :
       {std::pair(std::vector<double>(7, 1000), "has 7 healthy windows, but needs 8 or more"),
        std::pair(std::vector<double>(8, -1000), "/some/speed_rpm")}) {
    artefact::Writer writer("baselines");
    writer.numbers("/some/speed_rpm", speeds);
    writer.save(folder_ / "baselines.h5", {"test", "", {}});
    EXPECT_ERROR(Baselines::read({folder_ / "baselines.h5", "baselines"}, "/some", 12000),
                 Exit::bad_input, what);
  }
}

}  // namespace
}  // namespace piae::symptoms
