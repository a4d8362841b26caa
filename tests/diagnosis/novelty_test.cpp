#include "diagnosis/novelty.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "diagnosis/band_powers.hpp"
#include "diagnosis/dull_windows.hpp"
#include "diagnosis/sets.hpp"
#include "diagnosis/stored.hpp"
#include "support/errors.hpp"

namespace piae::diagnosis {
namespace {

using signal::WindowSet;

double distance(const FeatureRows& a, Eigen::Index i, const FeatureRows& b, Eigen::Index j) {
  return std::sqrt((a.row(i) - b.row(j)).squaredNorm());
}

/// Four healthy windows in two blocks of time, two faults, and windows to predict.
class NoveltyOfToys : public testing::Test {
 protected:
  NoveltyOfToys() {
    Stream stream("strange");
    for (int i = 0; i < 4; ++i) add_dull(reference_, 0, 0, stream);
    add_dull(reference_, 1, 0.9, stream);
    add_dull(reference_, 2, -0.9, stream);
    for (const double dull : {0.0, 0.9, -0.5, 0.3}) add_dull(tested_, 0, dull, stream);
    const WindowSet four = tested_;
    for (int i = 0; i < 70; ++i) tested_.append(four, 3);  // more than one batch
  }

  /// Returns the distance of a window to the nearest reference window whose label is not `but`.
  [[nodiscard]] double nearest(const FeatureRows& windows, Eigen::Index i, Label but) const {
    const FeatureRows bands = band_powers(reference_);
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index j = 0; j < bands.rows(); ++j) {
      if (reference_.labels[static_cast<std::size_t>(j)] == but) continue;
      least = std::min(least, distance(windows, i, bands, j));
    }
    return least;
  }
  [[nodiscard]] double threshold(Label but) const {
    const FeatureRows bands = band_powers(reference_);
    double largest = 0;
    for (Eigen::Index i = 0; i < bands.rows(); ++i) {
      if (reference_.labels[static_cast<std::size_t>(i)] == but) continue;
      double least = std::numeric_limits<double>::infinity();
      for (Eigen::Index j = 0; j < bands.rows(); ++j) {
        const auto own = static_cast<std::size_t>(i);
        const auto other = static_cast<std::size_t>(j);
        if (groups_[own] == groups_[other] || reference_.labels[other] == but) continue;
        least = std::min(least, distance(bands, i, bands, j));
      }
      largest = std::max(largest, least);
    }
    return largest;
  }
  void expect_by_hand(const Novelty& novelty, Label but) const {
    const std::vector<double> all = novelty.of(tested_);
    const FeatureRows tested = band_powers(tested_);
    ASSERT_EQ(all.size(), 74U);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double expected = nearest(tested, static_cast<Eigen::Index>(i), but) / threshold(but);
      EXPECT_NEAR(all[i], expected, 1e-9 * expected) << i;
    }
  }

  WindowSet reference_ = empty_set(1024);
  WindowSet tested_ = empty_set(1024);
  const std::vector<std::int32_t> groups_{0, 0, 1, 1, 9, 10};
};

TEST_F(NoveltyOfToys, IsTheNearestDistanceOverTheLargestLeftOutDistance) {
  expect_by_hand(Novelty(reference_, groups_), Label{-1});
}

TEST_F(NoveltyOfToys, WithoutAClassUsesTheOthers) {
  const Novelty novelty(reference_, groups_);
  expect_by_hand(novelty.without(1), 1);
  expect_by_hand(novelty.without(2), 2);
}

// Neighbours in time do not vouch for each other: a window and its copy in the same block.
TEST_F(NoveltyOfToys, LeavesOutWhatIsCloseInTime) {
  WindowSet reference = empty_set(1024);
  reference.append(reference_, 0);
  reference.append(reference_, 0);
  reference.append(reference_, 2);
  reference.append(reference_, 2);
  const FeatureRows bands = band_powers(reference);
  const double between = distance(bands, 0, bands, 2);
  WindowSet tested = empty_set(1024);
  tested.append(tested_, 1);
  const double to_nearest = std::min(distance(band_powers(tested), 0, bands, 0),
                                     distance(band_powers(tested), 0, bands, 2));
  EXPECT_NEAR(Novelty(reference, {0, 0, 1, 1}).of(tested)[0], to_nearest / between, 1e-9);
  // If each copy vouched for the other, the threshold would be almost 0.
  EXPECT_GT(Novelty(reference, {0, 1, 2, 3}).of(tested)[0], 1e4);
}

TEST_F(NoveltyOfToys, IsZeroForTheReferenceItself) {
  const std::vector<double> all = Novelty(reference_, groups_).of(reference_);
  EXPECT_LT(std::ranges::max(all), 1e-5);
}

TEST_F(NoveltyOfToys, NeedsTwoGroups) {
  EXPECT_THROW(Novelty(reference_, std::vector<std::int32_t>(6, 0)), std::logic_error);
}

TEST_F(NoveltyOfToys, IsReadAsWritten) {
  const Folder folder;
  const Novelty novelty(reference_, groups_);
  artefact::Writer writer("strangeness");
  novelty.write(writer, "/reference");
  const Novelty read(stored(writer, folder), "/reference", three_classes());
  EXPECT_EQ(read.of(tested_), novelty.of(tested_));
  EXPECT_EQ(read.without(1).of(tested_), novelty.without(1).of(tested_));
}

TEST_F(NoveltyOfToys, NeedsAPositiveThreshold) {
  const Folder folder;
  artefact::Writer writer("strangeness");
  write_bands(writer, "/reference", band_powers(reference_), reference_.labels);
  writer.numbers("/reference/groups", groups_);
  writer.attribute("/reference", "threshold", 0.0);
  EXPECT_ERROR(Novelty(stored(writer, folder), "/reference", three_classes()), Exit::bad_input,
               "threshold");
}

}  // namespace
}  // namespace piae::diagnosis
