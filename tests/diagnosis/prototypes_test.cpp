#include "diagnosis/prototypes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "diagnosis/stored.hpp"
#include "stages/doctor.hpp"
#include "support/errors.hpp"
#include "support/impact_windows.hpp"

namespace piae::diagnosis {
namespace {

constexpr std::size_t toy_length = 1024;

/// Few fault windows and many healthy ones, as in the ratio 100to1.
class PrototypesOfToys : public testing::Test {
 protected:
  PrototypesOfToys() {
    Stream stream("prototypes");
    add_impact_windows(training_, 0, 60, stream);
    for (const Label label : {1, 2}) add_impact_windows(training_, label, 5, stream);
    for (const Label label : {0, 1, 2}) add_impact_windows(test_, label, 20, stream);
    for (signal::WindowSet* const set : {&training_, &test_}) give_class_2_a_spectrum(*set);
  }
  /// Filters the windows of class 2, because the impact rate of a class hardly shows in bands.
  static void give_class_2_a_spectrum(signal::WindowSet& set) {
    for (const std::size_t i : set.indices_of(2)) {
      for (std::size_t t = i * toy_length + 1; t < (i + 1) * toy_length; ++t) {
        set.samples[t] += 0.5F * set.samples[t - 1];
      }
    }
  }
  [[nodiscard]] Learned trained(const std::string& stream = "toy",
                                const EpochDone& epoch_done = {}) const {
    return train_prototypes(training_, training_, 0, Stream(stream), epoch_done);
  }
  [[nodiscard]] Outputs outputs_of(const Learned& learned) const {
    return learned.trained->outputs(test_, "--test");
  }
  [[nodiscard]] artefact::Reader written(const Learned& learned) const {
    artefact::Writer writer("classifier");
    learned.trained->write(writer);
    return stored(writer, folder_);
  }

  const Folder folder_;
  signal::WindowSet training_ = no_impact_windows(toy_length);
  signal::WindowSet test_ = no_impact_windows(toy_length);
};

TEST_F(PrototypesOfToys, LearnFromFiveWindowsOfAFault) {
  const Learned learned = trained();
  EXPECT_EQ(most_likely(outputs_of(learned).scores, 3), test_.labels);
  const Training& training = learned.training;
  ASSERT_EQ(training.loss.size(), 50U);
  ASSERT_EQ(training.train_accuracy.size(), 50U);
  EXPECT_LT(training.loss.back(), training.loss.front() / 4);
  EXPECT_GT(training.train_accuracy.back(), 0.97);
  EXPECT_GT(training.seconds, 0);
}

// Prototypes are computed from the embeddings of the training windows that outputs() returns.
TEST_F(PrototypesOfToys, ScoresAreTheSoftmaxOfDistancesToMeanEmbeddings) {
  const Learned learned = trained();
  const Outputs known = learned.trained->outputs(training_, "");
  const Outputs tested = outputs_of(learned);
  ASSERT_EQ(tested.hidden.size(), 60U * 32);
  ASSERT_EQ(tested.logits.size(), 60U * 3);
  for (std::size_t i = 0; i < 60; i += 7) {
    double sum = 0;
    for (Label label = 0; label < 3; ++label) {
      const std::vector<std::size_t> own = training_.indices_of(label);
      double square = 0;
      for (std::size_t k = 0; k < 32; ++k) {
        double mean = 0;
        for (const std::size_t j : own) mean += known.hidden[32 * j + k];
        mean /= static_cast<double>(own.size());
        square += std::pow(tested.hidden[32 * i + k] - mean, 2);
      }
      const std::size_t at = 3 * i + index_of(label);
      EXPECT_NEAR(tested.logits[at], -square, 1e-4 * (1 + square));
      sum += std::exp(static_cast<double>(tested.logits[at]) - tested.logits[3 * i]);
    }
    EXPECT_NEAR(tested.scores[3 * i], 1 / sum, 1e-5);
  }
}

TEST_F(PrototypesOfToys, AreReproducibleForAStream) {
  const std::vector<float> once = outputs_of(trained("toy")).logits;
  EXPECT_EQ(outputs_of(trained("toy")).logits, once);
  EXPECT_NE(outputs_of(trained("other")).logits, once);
}

TEST_F(PrototypesOfToys, ReportEachEpoch) {
  std::vector<std::int64_t> epochs;
  std::vector<double> losses;
  const Learned learned = trained("toy", [&](std::int64_t done, double loss) {
    epochs.push_back(done);
    losses.push_back(loss);
  });
  std::vector<std::int64_t> all(50);
  std::iota(all.begin(), all.end(), 1);
  EXPECT_EQ(epochs, all);
  EXPECT_EQ(losses, learned.training.loss);
}

TEST_F(PrototypesOfToys, AreReadAsWritten) {
  const Learned learned = trained();
  const auto read = read_prototypes(written(learned), training_.info, toy_length);
  const Outputs was = outputs_of(learned);
  const Outputs is = read->outputs(test_, "");
  EXPECT_EQ(is.hidden, was.hidden);
  EXPECT_EQ(is.logits, was.logits);
  EXPECT_EQ(is.scores, was.scores);
}

TEST_F(PrototypesOfToys, DamagedContentIsRefused) {
  const Learned learned = trained();
  signal::DatasetInfo of_two = training_.info;
  of_two.classes.pop_back();
  EXPECT_ERROR(read_prototypes(written(learned), of_two, toy_length), Exit::bad_input,
               "/learned/prototypes");
  for (const std::string dataset :
       {"/learned/prototypes", "/learned/embedding/0/weight", "/learned/embedding/1/bias"}) {
    (void)written(learned);
    stages::doctor(folder_ / "stored.h5", [&](hid_t open) {
      artefact::hdf5::check(H5Ldelete(open, dataset.c_str(), H5P_DEFAULT), dataset.c_str());
    });
    EXPECT_ERROR(
        read_prototypes(artefact::Reader(folder_ / "stored.h5", ""), training_.info, toy_length),
        Exit::bad_input, dataset);
  }
}

TEST_F(PrototypesOfToys, AClassOfOneWindowHasAPrototype) {
  Stream stream("one");
  signal::WindowSet few = no_impact_windows(toy_length);
  add_impact_windows(few, 0, 10, stream);
  for (const Label label : {1, 2}) add_impact_windows(few, label, 1, stream);
  const Learned learned = train_prototypes(few, few, 0, Stream("one"));
  EXPECT_EQ(most_likely(learned.trained->outputs(few, "").scores, 3)[10], 1);
}

TEST_F(PrototypesOfToys, UnusableWindowsAreRefused) {
  Stream stream("unusable");
  signal::WindowSet healthy = no_impact_windows(toy_length);
  add_impact_windows(healthy, 0, 10, stream);
  EXPECT_ERROR(train_prototypes(healthy, healthy, 0, Stream("a")), Exit::bad_input,
               "class 'IR' has no window");
  signal::WindowSet single = no_impact_windows(toy_length);
  for (const Label label : {0, 1, 2}) add_impact_windows(single, label, 1, stream);
  EXPECT_ERROR(train_prototypes(single, single, 0, Stream("a")), Exit::bad_input,
               "each class has one window");
  signal::WindowSet other_length = no_impact_windows(512);
  add_impact_windows(other_length, 1, 1, stream);
  EXPECT_ERROR(trained().trained->outputs(other_length, "--test"), Exit::bad_input,
               "--test: windows of 512 samples, but the training windows have 1024");
}

}  // namespace
}  // namespace piae::diagnosis
