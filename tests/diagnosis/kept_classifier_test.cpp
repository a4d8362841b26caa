#include "diagnosis/kept_classifier.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "diagnosis/keep.hpp"
#include "diagnosis/learn.hpp"
#include "diagnosis/one_core_backend.hpp"
#include "diagnosis/stored.hpp"
#include "diagnosis/taught.hpp"
#include "diagnosis/training_set.hpp"
#include "stages/doctor.hpp"
#include "support/errors.hpp"
#include "support/impact_windows.hpp"

namespace piae::diagnosis {
namespace {

using signal::WindowSet;

/// Inputs of keep(): windows with the impacts of a bearing.
class Keep : public testing::Test {
 protected:
  Keep() {
    Stream stream("keep");
    add_impact_windows(normal_, 0, 20, stream);
    for (const Label label : {1, 2}) add_impact_windows(known_, label, 5, stream);
    for (const Label label : {0, 1, 2}) add_impact_windows(tested_, label, 4, stream);
    for (const Label label : {1, 2}) add_impact_windows(generated_, label, 5, stream, 14);
  }
  [[nodiscard]] Lessons lessons(std::int64_t per_class = 0) const {
    return {.normal = normal_,
            .known = known_,
            .generated = per_class > 0 ? &generated_ : nullptr,
            .generated_per_class = per_class};
  }
  [[nodiscard]] WindowSet training(std::int64_t per_class = 0) const {
    return compose_training_set(normal_, known_, per_class > 0 ? &generated_ : nullptr, per_class);
  }
  [[nodiscard]] KeptClassifier kept(const std::string& name, std::int64_t per_class = 0,
                                    const EpochDone& epoch_done = {}) const {
    const Classifier& classifier = the_classifier(name);
    const Stream stream("toy");
    const LearningSettings settings{.wdcnn = {.epochs = 2, .batch = 8, .learning_rate = 1e-3},
                                    .make_backend = make_one_core_backend,
                                    .unlabelled = &tested_,
                                    .network = &network_};
    const WindowSet set = training(per_class);
    return keep(classifier, learn(classifier, normal_, set, settings, stream).trained, set,
                lessons(per_class),
                {.settings = settings, .stream = stream, .epoch_done = epoch_done},
                {.method = "none",
                 .ratio = "100to1",
                 .generated_per_class = per_class,
                 .seed = 7,
                 .protocol = signal::Protocol::blocked,
                 .training_windows = 0,
                 .training_digest = ""});
  }
  [[nodiscard]] artefact::Reader written(const KeptClassifier& classifier) const {
    artefact::Writer writer("classifier");
    classifier.write(writer);
    return stored(writer, folder_);
  }
  /// Returns the number of reference windows of the novelty.
  [[nodiscard]] std::size_t reference_of(const KeptClassifier& classifier) const {
    return written(classifier).numbers<Label>("/reference/labels", {0}).values.size();
  }

  const Folder folder_;
  const artefact::Reader network_ = taught_network(folder_);
  WindowSet normal_ = no_impact_windows();
  WindowSet known_ = no_impact_windows();
  WindowSet generated_ = no_impact_windows();
  WindowSet tested_ = no_impact_windows();
};

void expect_almost(const std::vector<float>& all, const std::vector<float>& expected,
                   double tolerance) {
  ASSERT_EQ(all.size(), expected.size());
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_NEAR(all[i], expected[i], tolerance) << i;
}

// New classifiers of the catalogue must be storable, too.
TEST_F(Keep, EveryStoredClassifierPredictsTheSame) {
  for (const Classifier& classifier : classifiers()) {
    SCOPED_TRACE(classifier.name);
    KeptClassifier before = kept(classifier.name);
    const artefact::Reader reader = written(before);
    KeptClassifier after(reader);
    EXPECT_EQ(after.classifier().name, classifier.name);
    EXPECT_EQ(reader.text("/", "input"), classifier.input);
    const Outputs was = before.uncalibrated(tested_);
    const Outputs is = after.uncalibrated(tested_);
    const Predictions answered = before.predict(tested_);
    const Predictions predictions = after.predict(tested_);
    if (classifier.represent != nullptr) {
      EXPECT_EQ(is.logits, was.logits);
      EXPECT_EQ(is.hidden, was.hidden);
      EXPECT_EQ(predictions.probabilities, answered.probabilities);
    }
    expect_almost(is.scores, was.scores, 1e-6);
    expect_almost(predictions.probabilities, answered.probabilities, 1e-6);
    EXPECT_EQ(predictions.labels, answered.labels);
    EXPECT_EQ(predictions.novelty, answered.novelty);
  }
}

TEST_F(Keep, StoresKindAndOrigin) {
  const KeptClassifier before = kept("nearest");
  const KeptClassifier after(written(before));
  EXPECT_EQ(after.info().name, "toy");
  EXPECT_EQ(after.length(), 4096U);
  EXPECT_EQ(after.calibration().temperature, before.calibration().temperature);
  EXPECT_EQ(after.calibration().windows, 30);
  EXPECT_EQ(after.origin().method, "none");
  EXPECT_EQ(after.origin().ratio, "100to1");
  EXPECT_EQ(after.origin().generated_per_class, 0);
  EXPECT_EQ(after.origin().seed, 7);
  EXPECT_EQ(after.origin().protocol, signal::Protocol::blocked);
  EXPECT_EQ(after.origin().training_windows, 30);
  EXPECT_EQ(after.origin().training_digest, before.origin().training_digest);
  EXPECT_EQ(after.origin().training_digest.size(), 64U);
}

TEST_F(Keep, StoresTheDigestOfTheTrainingWindows) {
  const std::string digest = kept("nearest").origin().training_digest;
  EXPECT_EQ(kept("envelope-rule").origin().training_digest, digest);
  known_.samples[17] += 1;
  EXPECT_NE(kept("nearest").origin().training_digest, digest);
  known_.samples[17] -= 1;
  std::swap(known_.labels[0], known_.labels[9]);
  EXPECT_NE(kept("nearest").origin().training_digest, digest);
}

// The expected values are exp(logits / temperature), by hand.
TEST_F(Keep, ProbabilitiesUseTheTemperature) {
  KeptClassifier classifier = kept("envelope-rule");
  const double temperature = classifier.calibration().temperature;
  EXPECT_NE(temperature, 1);
  const std::vector<float> logits = classifier.uncalibrated(tested_).logits;
  const Predictions predictions = classifier.predict(tested_);
  for (std::size_t i = 0; i < tested_.size(); ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      sum += std::exp((logits[3 * i + k] - logits[3 * i]) / temperature);
    }
    EXPECT_NEAR(predictions.probabilities[3 * i], 1 / sum, 1e-6);
  }
  EXPECT_EQ(predictions.labels, tested_.labels);
}

// Each fold trains its own classifier with its own random numbers; none of these is kept.
TEST_F(Keep, TrainsAgainForEachFold) {
  std::int64_t epochs = 0;
  const KeptClassifier classifier =
      kept("symptom-net", 0, [&](std::int64_t /*done*/, double /*loss*/) { ++epochs; });
  EXPECT_EQ(epochs, 5 * 60);
  EXPECT_EQ(trainings_to_keep(training(), lessons()), 5);
}

TEST_F(Keep, TemperatureIsOneIfNothingCanBeLeftOut) {
  known_ = no_impact_windows();
  Stream stream("one");
  for (const Label label : {1, 2}) add_impact_windows(known_, label, 1, stream);
  const KeptClassifier classifier = kept("nearest");
  EXPECT_EQ(classifier.calibration().temperature, 1);
  EXPECT_EQ(classifier.calibration().windows, 0);
  EXPECT_EQ(trainings_to_keep(training(), lessons()), 0);
}

// Nine healthy windows suffice for a rule, but not after two of them are left out.
TEST_F(Keep, TemperatureIsOneWithTooFewHealthyWindows) {
  normal_ = no_impact_windows();
  Stream stream("nine");
  add_impact_windows(normal_, 0, 9, stream);
  for (const std::string name : {"envelope-rule", "symptom-net"}) {
    EXPECT_EQ(kept(name).calibration().windows, 0) << name;
  }
  add_impact_windows(normal_, 0, 1, stream);
  EXPECT_EQ(kept("envelope-rule").calibration().windows, 20);
}

TEST_F(Keep, NoveltyRefersToRealWindows) {
  EXPECT_EQ(reference_of(kept("nearest")), 30U);
  EXPECT_EQ(reference_of(kept("nearest", 5)), 30U);
  EXPECT_EQ(kept("nearest", 5).origin().training_windows, 40);
}

TEST_F(Keep, NoveltyIsUnavailableWithoutKnownFaults) {
  known_ = no_impact_windows();
  KeptClassifier nearest = kept("nearest", 5);
  EXPECT_FALSE(nearest.novelty());
  EXPECT_EQ(nearest.predict(tested_).novelty, std::vector<double>(tested_.size(), 0));
  EXPECT_FALSE(kept("exclusion-rule").novelty());
}

TEST_F(Keep, NoveltyIsUnavailableForFaultsOfOtherConditions) {
  for (WindowSet* set : {&normal_, &known_, &generated_, &tested_}) {
    set->info.conditions = {{.name = "slow", .shaft_speed_rpm = 1800, .test = false},
                            {.name = "fast", .shaft_speed_rpm = 1800, .known = false}};
    set->condition.assign(set->size(), 0);
    set->shaft_speed_rpm.assign(set->size(), 1800);
  }
  EXPECT_FALSE(kept("nearest", 5).novelty());
}

// These files are whole; only their content is wrong.
TEST_F(Keep, RefusesAClassifierThatCannotPredict) {
  const std::string file = folder_ / "stored.h5";
  const auto expect_refused = [&](const std::string& name, const std::string& what,
                                  const std::function<void(hid_t)>& change) {
    (void)written(kept(name));
    stages::doctor(file, change);
    EXPECT_ERROR(KeptClassifier(artefact::Reader(file, "classifier")), Exit::bad_input,
                 file + ": / " + what);
  };
  const auto length = [](std::int64_t samples) {
    return [=](hid_t open) { stages::replace_attribute(open, "/", "window_length", samples); };
  };
  for (const std::string name : {"wdcnn", "wdcnn-spectrum", "wdcnn-orders"}) {
    expect_refused(name, "cannot classify a window: WDCNN: ", length(2048));
  }
  // Half a turn of the shaft cannot separate the lines, and 255 samples are too few for 128 bands.
  expect_refused("envelope-rule", "cannot classify a window: ", length(200));
  for (const std::string name : {"nearest", "nearest-orders", "prototypes"}) {
    expect_refused(name, "cannot classify a window: windows of 255 samples", length(255));
  }
  const auto weights = [](const std::string& path) {
    return [=](hid_t open) {
      stages::change_numbers<float>(open, path, [](auto& all) { std::ranges::fill(all, 3e38F); });
    };
  };
  expect_refused("wdcnn",
                 "cannot classify a window: WDCNN: the outputs for a window are not finite",
                 weights("/learned/conv1/weight"));
  expect_refused("symptom-net", "gives NaN or infinite outputs for a window",
                 weights("/learned/classes/0/weight"));
  expect_refused("prototypes", "gives NaN or infinite outputs for a window",
                 weights("/learned/embedding/1/weight"));
}

}  // namespace
}  // namespace piae::diagnosis
