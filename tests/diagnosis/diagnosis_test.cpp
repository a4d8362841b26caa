#include "diagnosis/diagnosis.hpp"

#include <gtest/gtest.h>

#include "artefact/reader.hpp"
#include "diagnosis/catalogue.hpp"
#include "diagnosis/sets.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::diagnosis {
namespace {

/// Returns `of_each` windows of each of these classes.
signal::WindowSet tones_of(std::vector<Label> labels, std::size_t of_each,
                           const std::string& stream) {
  const LabelledWindows all = tones(of_each, stream);
  signal::WindowSet set = empty_set(all.length);
  for (std::size_t i = 0; i < all.labels.size(); ++i) {
    if (std::ranges::count(labels, all.labels[i]) == 0) continue;
    const auto first = all.samples.begin() + static_cast<std::ptrdiff_t>(i * all.length);
    set.samples.insert(set.samples.end(), first, first + static_cast<std::ptrdiff_t>(all.length));
    set.labels.push_back(all.labels[i]);
  }
  return set;
}

Inputs inputs_of_tones() {
  return {.test = tones_of({0, 1, 2}, 4, "test"),
          .normal = tones_of({0}, 20, "normal"),
          .known = tones_of({1, 2}, 5, "known"),
          .generated = std::nullopt};
}

Task task_of(const std::string& classifier, bool keep_features = false) {
  return {.classifier = the_classifier(classifier),
          .ratio = scoring::find_ratio("100to1"),
          .seed = 7,
          .keep_features = keep_features};
}

TEST(ADiagnosis, StoresWhatItLearnedFrom) {
  Diagnosis diagnosis(task_of("nearest"), inputs_of_tones(), "C.h5");
  EXPECT_EQ(diagnosis.epochs(true), 0U);
  diagnosis.learn();
  artefact::Writer writer("diagnosis");
  EXPECT_EQ(diagnosis.write(writer, true),
            "diagnosed 12 windows by the nearest of 30 (none 100to1, nearest, seed 7): accuracy "
            "100.00 %");
  const Folder folder;
  writer.save(folder.path() / "diagnosis.h5", {});
  const scoring::DiagnosisRecord record =
      scoring::read_diagnosis({folder.path() / "diagnosis.h5", "diagnosis"});
  EXPECT_EQ(record.classifier, "nearest");
  EXPECT_EQ(record.method, "none");
  EXPECT_EQ(record.seed, 7);
  EXPECT_EQ(record.true_ratio, 20.0 / 5.0);
  EXPECT_EQ(record.labels, (std::vector<Label>{0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2}));
  EXPECT_EQ(record.predictions, record.labels);
  EXPECT_EQ(record.train_windows_per_second, std::nullopt);
}

TEST(ADiagnosis, RefusesOptionsThatItsClassifierDoesNotSupport) {
  EXPECT_ERROR(Diagnosis(task_of("nearest", true), inputs_of_tones(), "C.h5"), Exit::usage,
               "--keep-features: nearest does not have layers");
  Inputs inputs = inputs_of_tones();
  inputs.generated = tones_of({1, 2}, 5, "generated");
  EXPECT_ERROR(Diagnosis(task_of("envelope-rule"), inputs, "C.h5"), Exit::usage,
               "--generated: envelope-rule is a rule");
  Task task = task_of("nearest");
  task.settings.prewhitening = 0.5;
  EXPECT_ERROR(Diagnosis(task, inputs_of_tones(), "C.h5"), Exit::usage,
               "--prewhitening: nearest does not take one");
}

}  // namespace
}  // namespace piae::diagnosis
