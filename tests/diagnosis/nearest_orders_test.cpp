#include "diagnosis/nearest_orders.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/random.hpp"
#include "diagnosis/log_spectrum.hpp"
#include "diagnosis/sets.hpp"
#include "diagnosis/stored.hpp"
#include "support/errors.hpp"

namespace piae::diagnosis {
namespace {

constexpr std::size_t order_length = 2048;

/// Adds a window of noise on a carrier of 3 kHz, modulated at an order of the shaft.
void add_modulated(signal::WindowSet& set, Label label, double order, double rpm, Stream& stream) {
  const double phase = stream.uniform(0, 2 * std::numbers::pi);
  for (std::size_t t = 0; t < set.length; ++t) {
    const double time_s = static_cast<double>(t) / set.info.sample_rate_hz;
    const double modulation = std::cos(2 * std::numbers::pi * order * rpm / 60 * time_s + phase);
    const double carrier = std::sin(2 * std::numbers::pi * 3000 * time_s);
    set.samples.push_back(
        static_cast<float>((1 + 0.8 * modulation) * carrier + stream.normal(0, 0.3)));
  }
  set.labels.push_back(label);
  set.shaft_speed_rpm.push_back(rpm);
}

/// Returns windows whose class is their order: 3.5 for class 1, and 5.5 for class 2.
signal::WindowSet modulated_at(double rpm, const std::string& stream_name, int of_each = 6) {
  Stream stream(stream_name);
  signal::WindowSet set = empty_set(order_length);
  for (int i = 0; i < of_each; ++i) {
    add_modulated(set, 1, 3.5, rpm, stream);
    add_modulated(set, 2, 5.5, rpm, stream);
  }
  return set;
}

scoring::Windows modulated_row(const signal::WindowSet& set, std::size_t i) {
  return Eigen::Map<const Eigen::RowVectorXf>(set.window(i).data(),
                                              static_cast<Eigen::Index>(set.length))
      .cast<double>();
}

std::vector<Label> named_by_orders(const signal::WindowSet& training,
                                   const signal::WindowSet& test) {
  return most_likely(learn_nearest_orders(training, training, 0, Stream("unused"), {})
                         .trained->outputs(test, "--test")
                         .scores,
                     3);
}

// 2048 samples at 12 kHz and 1800 rpm are 5.12 turns. A power is twice an amplitude in logarithms.
TEST(OrderFeatures, AreBandPowersAndWeightedPowersAtOrders) {
  const signal::WindowSet set = modulated_at(1800, "features", 1);
  const FeatureRows rows = order_features(set, "--test");
  ASSERT_EQ(rows.rows(), 2);
  ASSERT_EQ(rows.cols(), 224);
  EXPECT_EQ(rows.leftCols(128), band_powers(set));
  for (const Eigen::Index i : {0, 1}) {
    const scoring::Windows window = modulated_row(set, static_cast<std::size_t>(i));
    const Eigen::ArrayXd powers =
        2 * log_order_spectrum(window, 5.12, 96, 1e-5 * root_mean_square(window));
    const Eigen::ArrayXd orders = rows.row(i).tail(96).transpose();
    EXPECT_LT((orders - 0.7 * (powers - powers.mean())).abs().maxCoeff(), 1e-9);
    // Orders are 19.5 / 95 apart; those nearest to 3.5 and 5.5 are 14.6 and 24.4 steps from 0.5.
    Eigen::Index highest = 0;
    orders.maxCoeff(&highest);
    EXPECT_NEAR(static_cast<double>(highest), i == 0 ? 14.6 : 24.4, 1);
  }
}

TEST(OrderFeatures, IgnoreLevelAndOffset) {
  const signal::WindowSet set = modulated_at(1800, "level", 1);
  signal::WindowSet other = set;
  for (float& sample : other.samples) sample = 50 * sample + 20;
  EXPECT_LT((order_features(set, "") - order_features(other, "")).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(OrderFeatures, AreFiniteAtAnySpeedAndInAnyBand) {
  signal::WindowSet set = modulated_at(1800, "speeds", 2);
  set.shaft_speed_rpm = {0.01, 10, 60'000, 1e6};
  EXPECT_TRUE(order_features(set, "").allFinite());
  signal::WindowSet tone = empty_set(256);
  for (int t = 0; t < 256; ++t) {
    tone.samples.push_back(static_cast<float>(std::sin(std::numbers::pi / 4 * t + 1)));
  }
  tone.labels = {1};
  EXPECT_TRUE(order_features(tone, "").allFinite());
}

TEST(OrderFeatures, UnusableWindowsAreRefused) {
  signal::WindowSet constant = modulated_at(1800, "constant", 1);
  std::fill(constant.samples.begin() + order_length, constant.samples.end(), 4.0F);
  signal::WindowSet without_speed = modulated_at(1800, "without", 1);
  without_speed.shaft_speed_rpm[1] = std::numeric_limits<double>::quiet_NaN();
  signal::WindowSet shorter = empty_set(255);
  Stream stream("short");
  add_modulated(shorter, 1, 3.5, 1800, stream);
  const auto refused = [](const signal::WindowSet& set, const std::string& what) {
    EXPECT_ERROR(order_features(set, "--test"), Exit::bad_input, what);
  };
  refused(constant, "--test: window 1 (class OR) is constant");
  refused(without_speed,
          "--generated: the windows lack shaft speeds, which a spectrum over orders");
  refused(shorter, "windows of 255 samples");
}

// The lines at 2000 rpm have other frequencies than at 1500 rpm, but the same orders.
TEST(NearestOrders, RecognisesOrdersAtAnotherSpeed) {
  const signal::WindowSet test = modulated_at(2000, "test");
  EXPECT_EQ(named_by_orders(modulated_at(1500, "training"), test), test.labels);
}

TEST(NearestOrders, FindsATrainingWindowItself) {
  signal::WindowSet training = modulated_at(1500, "training");
  for (std::size_t i = 0; i < training.size(); ++i) training.labels[i] = static_cast<Label>(i % 3);
  EXPECT_EQ(named_by_orders(training, training), training.labels);
}

TEST(NearestOrders, IsReadAsWritten) {
  const Folder folder;
  const signal::WindowSet training = modulated_at(1500, "training");
  const signal::WindowSet test = modulated_at(1700, "test");
  const Learned made = learn_nearest_orders(training, training, 0, Stream("unused"), {});
  artefact::Writer writer("classifier");
  made.trained->write(writer);
  const artefact::Reader reader = stored(writer, folder);
  const auto read = read_nearest_orders(reader, training.info, order_length);
  EXPECT_EQ(read->outputs(test, "").logits, made.trained->outputs(test, "").logits);
  EXPECT_EQ(read->outputs(test, "").scores, made.trained->outputs(test, "").scores);
  EXPECT_ERROR(read->outputs(empty_set(1024), "--test"), Exit::bad_input, "both must be the same");
  // A classifier by band powers has 128 columns.
  EXPECT_ERROR(read_nearest(reader, training.info, order_length), Exit::bad_input,
               "/learned/bands");
}

}  // namespace
}  // namespace piae::diagnosis
