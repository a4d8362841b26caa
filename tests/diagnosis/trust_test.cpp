#include "diagnosis/trust.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/dull_windows.hpp"
#include "diagnosis/sets.hpp"
#include "diagnosis/stored.hpp"
#include "support/errors.hpp"

namespace piae::diagnosis {
namespace {

using signal::WindowSet;

/// Returns the given logits for any windows.
class Told final : public Trained {
 public:
  explicit Told(std::vector<float> logits) : logits_(std::move(logits)) {}
  Outputs outputs(const WindowSet& windows, const std::string& /*what*/) override {
    Outputs outputs;
    outputs.logits = logits_;
    for (std::size_t i = 0; i < windows.size(); ++i) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum += std::exp(logits_[3 * i + k]);
      for (std::size_t k = 0; k < 3; ++k) {
        outputs.scores.push_back(static_cast<float>(std::exp(logits_[3 * i + k]) / sum));
      }
    }
    return outputs;
  }
  void write(artefact::Writer& /*writer*/) const override {}

 private:
  std::vector<float> logits_;
};

class TrustByHand : public testing::Test {
 protected:
  TrustByHand() {
    Stream stream("trust");
    for (int i = 0; i < 6; ++i) add_dull(reference_, 0, 0, stream);
    for (const double dull : {0.8, 0.9}) add_dull(reference_, 1, dull, stream);
    for (const double dull : {-0.8, -0.9}) add_dull(reference_, 2, dull, stream);
    for (const Label label : {0, 1, 2, 0, 1, 2, 1, 2}) {
      add_dull(test_, label, label == 0 ? 0.05 : label == 1 ? 0.85 : -0.85, stream);
    }
    for (int t = 0; t < 1024; ++t) {  // a tone, unlike all of them
      test_.samples.push_back(static_cast<float>(std::sin(0.5 * t) + stream.normal(0, 0.01)));
    }
    test_.labels.push_back(2);
  }
  /// Returns a classifier that gives the first six windows high scores, four of them correctly; the
  /// others have lower scores.
  [[nodiscard]] KeptClassifier kept(double temperature) const {
    const auto sure = static_cast<float>(std::log(18.0));
    const auto less_sure = static_cast<float>(std::log(2.0));
    std::vector<float> logits;
    const std::vector<Label> named{0, 1, 2, 0, 2, 1, 1, 0, 0};
    for (std::size_t i = 0; i < named.size(); ++i) {
      for (const Label label : {0, 1, 2}) {
        logits.push_back(label == named[i] ? (i < 6 ? sure : less_sure) : 0);
      }
    }
    return {three_classes(),
            1024,
            the_classifier("nearest"),
            std::make_unique<Told>(logits),
            {.temperature = temperature, .windows = 9},
            novelty(),
            {}};
  }
  [[nodiscard]] Novelty novelty() const { return {reference_, {0, 0, 1, 1, 2, 2, 3, 4, 5, 6}}; }
  WindowSet reference_ = empty_set(1024);
  WindowSet test_ = empty_set(1024);
};

// exp(ln 18) = 18 against 1 and 1 is 0.9, with four of six correct; 2 against 1 and 1 is 0.5, with
// one of three correct. The temperature ln 18 / ln 4 makes the first 4 against 1 and 1.
TEST_F(TrustByHand, HasAccuracyAndCalibrationError) {
  const double temperature = std::log(18.0) / std::log(4.0);
  KeptClassifier classifier = kept(temperature);
  const Trust trust = trust_in(classifier, test_);
  EXPECT_DOUBLE_EQ(trust.accuracy, 5.0 / 9);
  EXPECT_NEAR(trust.raw_calibration_error, (6 * (0.9 - 4.0 / 6) + 3 * (0.5 - 1.0 / 3)) / 9, 1e-6);
  const double less_sure = std::pow(2, 1 / temperature) / (std::pow(2, 1 / temperature) + 2);
  EXPECT_NEAR(trust.calibration_error, 3 * (less_sure - 1.0 / 3) / 9, 1e-6);
}

TEST_F(TrustByHand, CountsWindowsCalledUnknown) {
  KeptClassifier classifier = kept(1);
  const std::vector<double> novelties = novelty().of(test_);
  EXPECT_GT(novelties[8], 1);
  const auto count = std::ranges::count_if(novelties, [](double s) { return s > 1; });
  EXPECT_LT(count, 9);
  EXPECT_DOUBLE_EQ(trust_in(classifier, test_).called_unknown, static_cast<double>(count) / 9);
}

// Compares pairs: windows of the left-out class against all others.
TEST_F(TrustByHand, DistinguishesAnUntrainedClassFromTheOthers) {
  KeptClassifier classifier = kept(1);
  const Trust trust = trust_in(classifier, test_);
  ASSERT_EQ(trust.untrained.size(), 2U);  // healthy windows are always trained
  for (const Label label : {1, 2}) {
    const std::vector<double> novelties = novelty().without(label).of(test_);
    double won = 0;
    double pairs = 0;
    double unknown = 0;
    for (std::size_t i = 0; i < 9; ++i) {
      if (test_.labels[i] != label) continue;
      unknown += novelties[i] > 1 ? 1 : 0;
      for (std::size_t j = 0; j < 9; ++j) {
        if (test_.labels[j] == label) continue;
        ++pairs;
        won += novelties[i] > novelties[j] ? 1 : 0;
      }
    }
    EXPECT_NEAR(trust.untrained.at(label).auroc, won / pairs, 1e-12);
    EXPECT_DOUBLE_EQ(trust.untrained.at(label).called_unknown,
                     unknown / static_cast<double>(test_.count_of(label)));
  }
  // Only one of the six other windows is more novel than class 1: the tone, which is of class 2.
  EXPECT_NEAR(trust.untrained.at(1).auroc, 5.0 / 6, 1e-12);
  EXPECT_EQ(trust.untrained.at(2).auroc, 1);
}

class StoredTrust : public testing::Test {
 protected:
  [[nodiscard]] artefact::Reader written(const Trust& trust) const {
    artefact::Writer writer("classifier");
    write(writer, trust);
    return stored(writer, folder_);
  }
  const Folder folder_;
  const Trust trust_{.accuracy = 0.9,
                     .raw_calibration_error = 0.2,
                     .calibration_error = 0.02,
                     .called_unknown = 0.05,
                     .untrained = {{1, {.auroc = 0.99, .called_unknown = 0.8}},
                                   {2, {.auroc = 0.95, .called_unknown = 0.6}}}};
};

TEST_F(StoredTrust, IsReadAsWritten) {
  const Trust read = read_trust(written(trust_), three_classes());
  EXPECT_EQ(read.accuracy, 0.9);
  EXPECT_EQ(read.raw_calibration_error, 0.2);
  EXPECT_EQ(read.calibration_error, 0.02);
  EXPECT_EQ(read.called_unknown, 0.05);
  ASSERT_EQ(read.untrained.size(), 2U);
  EXPECT_EQ(read.untrained.at(1).auroc, 0.99);
  EXPECT_EQ(read.untrained.at(2).called_unknown, 0.6);
}

TEST_F(StoredTrust, NeedsSharesFromZeroToOne) {
  Trust more = trust_;
  more.calibration_error = 1.1;
  EXPECT_ERROR(read_trust(written(more), three_classes()), Exit::bad_input, "calibration_error");
  more = trust_;
  more.untrained[2].auroc = -0.1;
  EXPECT_ERROR(read_trust(written(more), three_classes()), Exit::bad_input,
               "/trust/untrained_auroc");
}

// Entries for classes that do not exist, or for healthy windows, are never written.
TEST_F(StoredTrust, NamesEachFaultClassOnce) {
  for (const Label label : {-1, 0, 3}) {
    Trust other = trust_;
    other.untrained[label] = other.untrained.extract(1).mapped();
    EXPECT_ERROR(read_trust(written(other), three_classes()), Exit::bad_input,
                 "/trust/untrained_class must name each fault class once");
  }
  Trust less = trust_;
  less.untrained.erase(2);
  EXPECT_ERROR(read_trust(written(less), three_classes()), Exit::bad_input,
               "/trust/untrained_class");
}

}  // namespace
}  // namespace piae::diagnosis
