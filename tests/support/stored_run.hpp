#pragma once

#include <gmock/gmock.h>

#include <algorithm>
#include <string>
#include <utility>

#include "run/collect.hpp"
#include "scoring/diagnosis_record.hpp"
#include "scoring/quality_record.hpp"
#include "support/folder.hpp"
#include "support/three_classes.hpp"

namespace piae {

/// A run in a temporary folder: a data set with three classes and 20 windows in A.
class StoredRun : public testing::Test {
 protected:
  explicit StoredRun(std::string dataset = "cwru") : dataset_(std::move(dataset)) {}

  /// Returns a diagnosis with `right` of the 20 windows correct; each counts 5 points.
  [[nodiscard]] scoring::DiagnosisRecord diagnosis(const std::string& method,
                                                   const std::string& ratio, int generated,
                                                   int seed, int right) const {
    scoring::DiagnosisRecord record;
    record.info = three_classes(dataset_);
    record.method = method;
    record.ratio = ratio;
    record.generated_per_class = generated;
    record.true_ratio = 500.0 / (5 + generated);
    record.seed = seed;
    record.protocol = signal::Protocol::random;
    record.labels.assign(20, 1);
    record.predictions.assign(20, 2);
    std::fill_n(record.predictions.begin(), right, 1);
    record.scores.assign(60, 0);
    record.loss = {1};
    record.train_accuracy = {1};
    return record;
  }
  [[nodiscard]] scoring::QualityRecord quality(const std::string& method, int seed,
                                               double value) const {
    return {three_classes(dataset_),
            method,
            seed,
            signal::Protocol::random,
            {{1, 9, value, 2 * value, 3, 4, 5, 6, 7}, {2, 9, 1e-7, 1, 1, 1, 1, 1, 1}}};
  }
  template <class Record>
  static void save(const std::string& kind, const Record& record,
                   const std::filesystem::path& path) {
    artefact::Writer writer(kind);
    scoring::write(writer, record);
    writer.save(path, {"test", "", {}});
  }
  void add(const scoring::DiagnosisRecord& record) const {
    save("diagnosis", record,
         layout_.diagnosis(record.method, record.ratio, record.seed, record.classifier));
  }
  /// Returns the same diagnosis by another classifier.
  [[nodiscard]] static scoring::DiagnosisRecord by(const std::string& classifier,
                                                   scoring::DiagnosisRecord record) {
    record.classifier = classifier;
    return record;
  }
  void add(const scoring::QualityRecord& record) const {
    save("score", record, layout_.score(record.method, record.seed));
  }
  /// Adds seeds 0 and 1 of `none`: 60 and 65 percent.
  void add_baseline() const {
    add(diagnosis("none", "100to1", 0, 0, 12));
    add(diagnosis("none", "100to1", 0, 1, 13));
  }
  /// Adds seeds 0 and 1 of a method: 75 and 75 percent at 10to1, 85 and 95 at 2to1.
  void add_method(const std::string& method) const {
    add(diagnosis(method, "10to1", 45, 0, 15));
    add(diagnosis(method, "10to1", 45, 1, 15));
    add(diagnosis(method, "2to1", 145, 0, 17));
    add(diagnosis(method, "2to1", 145, 1, 19));
    add(quality(method, 0, 0.5));
    add(quality(method, 1, 0.7));
  }
  void add_all() const {
    add_baseline();
    add_method("vae");
  }
  [[nodiscard]] run::Grid grid(const std::string& methods, const std::string& ratios,
                               const std::string& seeds = "0 1") const {
    return resolve(run::GridOptions{dataset_, {methods}, {ratios}, {seeds}});
  }

  const std::string dataset_;
  Folder folder_;
  const run::Layout layout_{folder_.path() / "run", dataset_};
  const run::Grid grid_ = grid("none vae", "100to1 10to1 2to1");
};

}  // namespace piae
