#pragma once

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

#include "run/collect.hpp"
#include "report/published.hpp"
#include "scoring/diagnosis_record.hpp"
#include "scoring/sets.hpp"

namespace piae::report {

/// A run in a temporary folder: a dataset with three classes and 20 windows in A, and published
/// figures beside it.
class Run : public testing::Test {
 protected:
  explicit Run(const std::string& dataset = "cwru") : dataset_(dataset) {
    write_text("table6-7-baseline.csv",
               "dataset,run1,run2,run3,average\ncwru,61.8,62,61.7,61.8\nhfhp,61,62,63,62\n");
    write_text("table8-9-methods.csv",
               "dataset,method,2to1\ncwru,vae,91.2\ncwru,piae-dt,93.7\nhfhp,vae,90.86\n");
    write_text("table10-11-ablation.csv",
               "dataset,model,2to1\ncwru,model1,93.7\ncwru,model2,91.7\n");
  }
  void write_text(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name) << text;
  }

  /// `right` of the 20 windows are recognised: each is worth 5 points.
  [[nodiscard]] scoring::DiagnosisRecord diagnosis(const std::string& method,
                                                   const std::string& ratio, int generated,
                                                   int seed, int right) const {
    scoring::DiagnosisRecord record;
    record.info = testing_sets::three_classes(dataset_);
    record.method = method;
    record.ratio = ratio;
    record.generated_per_class = generated;
    record.true_ratio = 500.0 / (5 + generated);
    record.seed = seed;
    record.protocol = "random";
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
    return {testing_sets::three_classes(dataset_),
            method,
            seed,
            "random",
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
    save("diagnosis", record, layout_.diagnosis(record.method, record.ratio, record.seed));
  }
  void add(const scoring::QualityRecord& record) const {
    save("score", record, layout_.score(record.method, record.seed));
  }
  /// Seeds 0 and 1 of `none`: 60 and 65 percent.
  void add_baseline() const {
    add(diagnosis("none", "100to1", 0, 0, 12));
    add(diagnosis("none", "100to1", 0, 1, 13));
  }
  /// The same of a method: 75 and 75 percent at 10to1, 85 and 95 at 2to1.
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
  [[nodiscard]] Grid grid(const std::string& methods, const std::string& ratios,
                          const std::string& seeds = "0 1") const {
    return resolve(GridOptions{dataset_, {methods}, {ratios}, {seeds}});
  }
  [[nodiscard]] Published published() const { return Published(folder_.path()); }

  const std::string dataset_;
  testing_sets::TemporaryFolder folder_;
  const Layout layout_{folder_.path() / "run", dataset_};
  const Grid grid_ = grid("none vae", "100to1 10to1 2to1");
};

}  // namespace piae::report
