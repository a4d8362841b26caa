#include "report/trust_table.hpp"

#include <gmock/gmock.h>

#include "diagnosis/learn.hpp"
#include "support/errors.hpp"
#include "support/impact_windows.hpp"
#include "support/stored_run.hpp"

namespace piae::report {
namespace {

using testing::HasSubstr;

/// Kept classifiers of two seeds with given numbers.
class TrustTable : public StoredRun {
 protected:
  TrustTable() {
    keep("none", "nearest", 0, trust({0.90, 0.99, 0.95}), 1.5);
    keep("none", "nearest", 1, trust({0.94, 0.97, 0.91}), 2.5);
  }

  /// Accuracy, and areas of two classes.
  struct Figures {
    double accuracy;
    double inner;
    double outer;
  };
  static diagnosis::Trust trust(const Figures& figures) {
    return {.accuracy = figures.accuracy,
            .raw_calibration_error = 0.1,
            .calibration_error = 0.02,
            .called_unknown = 0.04,
            .untrained = {{1, {.auroc = figures.inner, .called_unknown = 0.8}},
                          {2, {.auroc = figures.outer, .called_unknown = 0.6}}}};
  }
  void keep(const std::string& method, const std::string& classifier, std::int64_t seed,
            const diagnosis::Trust& trust, double temperature, std::int64_t said_seed = -1) const {
    Stream stream("kept");
    signal::WindowSet windows = no_impact_windows(256);
    windows.info = three_classes(dataset_);
    for (const Label label : {0, 1, 2}) add_impact_windows(windows, label, 2, stream);
    const diagnosis::Classifier& entry = diagnosis::the_classifier("nearest");
    const diagnosis::KeptClassifier kept(
        windows.info, windows.length, entry,
        diagnosis::learn(entry, windows, windows, {}, stream).trained,
        {.temperature = temperature, .windows = 6}, diagnosis::Novelty(windows, {0, 1, 2, 3, 4, 5}),
        {.method = method,
         .ratio = "100to1",
         .generated_per_class = 0,
         .seed = said_seed < 0 ? seed : said_seed,
         .protocol = signal::Protocol::random,
         .training_windows = 6,
         .training_digest = "0123"});
    artefact::Writer writer("classifier");
    kept.write(writer);
    write(writer, trust);
    writer.save(layout_.kept_classifier(method, "100to1", seed, classifier), {"test", "", {}});
  }
  [[nodiscard]] run::Grid cells(const std::string& classifier = "nearest") const {
    return {.dataset = dataset_,
            .scored = {},
            .combinations = {{.method = "none", .ratio = "100to1", .classifier = classifier}},
            .seeds = {0, 1}};
  }
};

TEST_F(TrustTable, ShowsMeansOverTheSeedsInPercent) {
  const std::vector<TrustRow> rows = trust_rows(layout_, cells());
  ASSERT_EQ(rows.size(), 1U);
  const TrustRow& row = rows.front();
  EXPECT_NEAR(row.accuracy.mean, 92, 1e-9);
  EXPECT_NEAR(*row.accuracy.deviation, 2 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(row.raw_calibration_error.mean, 10, 1e-9);
  EXPECT_NEAR(row.calibration_error.mean, 2, 1e-9);
  EXPECT_NEAR(row.called_unknown.mean, 4, 1e-9);
  EXPECT_NEAR(row.temperature.mean, 2, 1e-9);
  EXPECT_NEAR(row.auroc.value().mean, 0.955, 1e-9);  // of 0.97 and 0.94
  EXPECT_NEAR(row.untrained_called_unknown.value().mean, 70, 1e-9);
  ASSERT_EQ(row.auroc_by_class.size(), 2U);
  EXPECT_EQ(row.auroc_by_class[0].first, "IR");
  EXPECT_NEAR(row.auroc_by_class[0].second.mean, 0.98, 1e-9);
  EXPECT_EQ(row.auroc_by_class[1].first, "OR");
  EXPECT_NEAR(row.auroc_by_class[1].second.mean, 0.93, 1e-9);
}

TEST_F(TrustTable, IsWrittenAsCsv) {
  EXPECT_EQ(trust_csv(dataset_, trust_rows(layout_, cells())),
            "dataset,classifier,method,ratio,seeds,quantity,class,mean,std\n"
            "cwru,nearest,none,100to1,2,accuracy,,92.0000,2.8284\n"
            "cwru,nearest,none,100to1,2,raw_calibration_error,,10.0000,0.0000\n"
            "cwru,nearest,none,100to1,2,calibration_error,,2.0000,0.0000\n"
            "cwru,nearest,none,100to1,2,temperature,,2.0000,0.7071\n"
            "cwru,nearest,none,100to1,2,called_unknown,,4.0000,0.0000\n"
            "cwru,nearest,none,100to1,2,untrained_auroc,,0.9550,0.0212\n"
            "cwru,nearest,none,100to1,2,untrained_called_unknown,,70.0000,0.0000\n"
            "cwru,nearest,none,100to1,2,untrained_auroc,IR,0.9800,0.0141\n"
            "cwru,nearest,none,100to1,2,untrained_auroc,OR,0.9300,0.0283\n");
}

TEST_F(TrustTable, IsShownInTables) {
  const std::string text = markdown(trust_document(dataset_, trust_rows(layout_, cells())));
  EXPECT_THAT(text, HasSubstr("# cwru: how far kept classifiers are to be believed"));
  EXPECT_THAT(
      text,
      HasSubstr(
          "| none by nearest | 100:1 | 92.0 ± 2.8 |  10.0 ± 0.0 |  2.0 ± 0.0 | 2.00 ± 0.71 |"));
  EXPECT_THAT(text, HasSubstr("| untrained: area | untrained: unknown |"));
  EXPECT_THAT(text, HasSubstr("|      4.0 ± 0.0 |   0.955 ± 0.021 |         70.0 ± 0.0 |"));
  EXPECT_THAT(text, HasSubstr("| IR                | none by nearest | 100:1 | 0.980 ± 0.014 |"));
}

TEST_F(TrustTable, NeedsTheClassifierOfEachCell) {
  EXPECT_ERROR(trust_rows(layout_, cells("wdcnn")), Exit::input_missing,
               "seed0/none/100to1/wdcnn/classifier.h5");
  keep("none", "wdcnn", 0, trust({0.9, 0.9, 0.9}), 1);
  EXPECT_ERROR(trust_rows(layout_, cells("wdcnn")), Exit::bad_input,
               "is nearest of cwru, none 100to1, seed 0; here it must be wdcnn of cwru");
  keep("none", "nearest", 1, trust({0.9, 0.9, 0.9}), 1, 5);
  EXPECT_ERROR(trust_rows(layout_, cells()), Exit::bad_input,
               "seed 5; here it must be nearest of cwru, none 100to1, seed 1");
}

}  // namespace
}  // namespace piae::report
