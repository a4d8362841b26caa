#include "diagnosis/band_powers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/random.hpp"
#include "diagnosis/sets.hpp"
#include "diagnosis/stored.hpp"
#include "support/errors.hpp"
#include "support/three_classes.hpp"

namespace piae::diagnosis {
namespace {

signal::WindowSet one_window(const std::vector<float>& samples) {
  signal::WindowSet set = empty_set(samples.size());
  set.samples = samples;
  set.labels = {0};
  return set;
}

// Four of the 512 bins above the offset make a band: the 102nd bin is in the 26th band.
TEST(BandPowers, ToneGivesHighestBandAtItsFrequency) {
  std::vector<float> tone;
  for (int t = 0; t < 1024; ++t) {
    tone.push_back(static_cast<float>(std::sin(2 * std::numbers::pi * 102 * t / 1024)));
  }
  const FeatureRows bands = band_powers(one_window(tone));
  ASSERT_EQ(bands.rows(), 1);
  ASSERT_EQ(bands.cols(), 128);
  Eigen::Index highest = 0;
  bands.row(0).maxCoeff(&highest);
  EXPECT_EQ(highest, 25);
}

// The spectrum of an impulse is flat. Its removed mean changes only the first bins under Hann's
// window, so all other bands are the same, as far above the mean as the first is below.
TEST(BandPowers, ImpulseGivesFlatBandsWithZeroMean) {
  std::vector<float> impulse(1024);
  impulse[300] = 5;
  const FeatureRows bands = band_powers(one_window(impulse));
  EXPECT_NEAR(bands.row(0).sum(), 0, 1e-9);
  for (Eigen::Index band = 2; band < 128; ++band) EXPECT_NEAR(bands(0, band), bands(0, 1), 1e-6);
  EXPECT_NEAR(bands(0, 0), -127 * bands(0, 1), 1e-6);
}

TEST(BandPowers, IgnoreLevelAndOffset) {
  Stream stream("bands");
  std::vector<float> low_level(1024);
  for (float& sample : low_level) sample = static_cast<float>(stream.normal(0, 1));
  std::vector<float> high_level = low_level;
  for (float& sample : high_level) sample = 64 * sample + 100;
  const FeatureRows difference =
      band_powers(one_window(low_level)) - band_powers(one_window(high_level));
  EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-3);
}

TEST(BandPowers, NeedTwoBinsPerBand) {
  EXPECT_EQ(band_powers(one_window(std::vector<float>(256, 1.0F))).rows(), 1);
  EXPECT_ERROR(band_powers(one_window(std::vector<float>(255, 1.0F))), Exit::bad_input,
               "windows of 255 samples: 128 bands need 256 samples or more");
}

FeatureRows random_bands(Eigen::Index rows, const std::string& stream_name) {
  Stream stream(stream_name);
  FeatureRows bands(rows, number_of_bands);
  for (Eigen::Index i = 0; i < bands.size(); ++i) bands.data()[i] = stream.normal(0, 3);
  return bands;
}

TEST(Neighbours, DistanceIsTheSumOfSquares) {
  const FeatureRows known = random_bands(5, "known");
  const FeatureRows tested = random_bands(3, "asked");
  const Neighbours neighbours(known);
  EXPECT_EQ(neighbours.known(), known);
  const Eigen::MatrixXd squares = neighbours.squared_distances(tested);
  ASSERT_EQ(squares.rows(), 5);
  ASSERT_EQ(squares.cols(), 3);
  for (Eigen::Index i = 0; i < 5; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j) {
      double sum = 0;
      for (Eigen::Index band = 0; band < number_of_bands; ++band) {
        sum += (known(i, band) - tested(j, band)) * (known(i, band) - tested(j, band));
      }
      EXPECT_NEAR(squares(i, j), sum, 1e-10 * sum);
    }
  }
}

TEST(Neighbours, DistanceIsNeverNegative) {
  const FeatureRows known = random_bands(20, "known");
  const Eigen::MatrixXd squares = Neighbours(known).squared_distances(known);
  EXPECT_GE(squares.minCoeff(), 0);
  EXPECT_LT(squares.diagonal().maxCoeff(), 1e-9);
}

class StoredBands : public testing::Test {
 protected:
  StoredBands() {
    for (Eigen::Index i = 0; i < bands_.size(); ++i)
      bands_.data()[i] = 0.1 * static_cast<double>(i);
  }
  [[nodiscard]] artefact::Reader with_labels(const std::vector<Label>& labels) const {
    artefact::Writer writer("bands");
    writer.numbers("/some/labels", labels);
    return stored(writer, folder_);
  }

  const Folder folder_;
  FeatureRows bands_{2, number_of_bands};
};

TEST_F(StoredBands, AreReadAsWritten) {
  artefact::Writer writer("bands");
  write_bands(writer, "/some", bands_, {2, 0});
  const artefact::Reader reader = stored(writer, folder_);
  EXPECT_EQ(read_labels(reader, "/some", three_classes()), (std::vector<Label>{2, 0}));
  EXPECT_EQ(read_bands(reader, "/some", 2), bands_);
  EXPECT_ERROR(read_bands(reader, "/some", 3), Exit::bad_input, "/some/bands");
}

TEST_F(StoredBands, NeedAValidLabelEach) {
  for (const Label none : {-1, 3}) {
    EXPECT_ERROR(read_labels(with_labels({0, none}), "/some", three_classes()), Exit::bad_input,
                 "/some/labels has a label without a class");
  }
  EXPECT_ERROR(read_labels(with_labels({}), "/some", three_classes()), Exit::bad_input,
               "/some/labels is empty");
}

}  // namespace
}  // namespace piae::diagnosis
