// Mean accuracy of methods over data sets.

#include "report/transfer.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "report/accuracy_rows.hpp"
#include "report/transfer_tables.hpp"
#include "support/errors.hpp"
#include "support/shown.hpp"
#include "support/stored_run.hpp"

namespace piae::report {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

AccuracyRow row_by(const std::string& classifier, AccuracyRow row) {
  row.classifier = classifier;
  row.speed_ratio = 0.75;
  return row;
}

/// Returns the rows with the name of their data set.
DatasetRows dataset_of(const std::string& name, std::vector<AccuracyRow> rows) {
  for (AccuracyRow& row : rows) row.dataset = name;
  return {name, std::move(rows)};
}

/// Five seeds of two data sets. The means over both are: strike-twin 80 at every seed; none 79, 78,
/// 77, 76, 75 by its recorded input and 79 by another; shift 81, 78, 77, 76, 75; none by nearest
/// 81, 82, 77, 76, 75. vae has no recorded input.
std::vector<DatasetRows> two_datasets() {
  return {dataset_of(
              "a", {row_by("wdcnn", row_with("none", "100to1", {80, 76, 77, 70, 70})),
                    row_by("wdcnn-spectra", row_with("none", "100to1", {79, 79, 79, 79, 79})),
                    row_by("nearest", row_with("none", "100to1", {82, 82, 77, 76, 75})),
                    row_by("wdcnn", row_with("vae", "1to1", {9, 9, 9, 9, 9})),
                    row_by("wdcnn-spectra", row_with("strike-twin", "1to1", {90, 70, 80, 85, 75})),
                    row_by("wdcnn", row_with("shift", "1to1", {82, 76, 77, 70, 70})),
                    row_by("wdcnn", row_with("oracle", "1to1", {100, 100, 100, 100, 100}))}),
          dataset_of(
              "b", {row_by("wdcnn", row_with("none", "100to1", {78, 80, 77, 82, 80})),
                    row_by("wdcnn-spectra", row_with("none", "100to1", {79, 79, 79, 79, 79})),
                    row_by("nearest", row_with("none", "100to1", {80, 82, 77, 76, 75})),
                    row_by("wdcnn", row_with("vae", "1to1", {9, 9, 9, 9, 9})),
                    row_by("wdcnn-spectra", row_with("strike-twin", "1to1", {70, 90, 80, 75, 85})),
                    row_by("wdcnn", row_with("shift", "1to1", {80, 80, 77, 82, 80})),
                    row_by("wdcnn", row_with("oracle", "1to1", {100, 100, 100, 100, 100}))})};
}

const GroupChoices choices{
    "g",
    "strike-twin",
    {{"none", "wdcnn"}, {"strike-twin", "wdcnn-spectra"}, {"shift", "wdcnn"}, {"oracle", "wdcnn"}}};

TEST(TransferGroup, AveragesOverTheDatasetsSeedBySeed) {
  const TransferGroup group = transfer_group(choices, two_datasets());
  EXPECT_THAT(group.datasets, ElementsAre("a", "b"));
  EXPECT_THAT(group.seeds, ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(group.own()->mean.row.values, ElementsAre(80, 80, 80, 80, 80));
  EXPECT_THAT(group.own()->datasets[1].row.values, ElementsAre(70, 90, 80, 75, 85));
  ASSERT_EQ(group.references().size(), 1U);
  EXPECT_THAT(group.references().front()->mean.row.values, ElementsAre(81, 82, 77, 76, 75));
  EXPECT_EQ(group.own()->mean.row.summary.deviation, 0);
  const AccuracyRow none = group.recorded().front()->mean.row;
  EXPECT_THAT(none.values, ElementsAre(79, 78, 77, 76, 75));
  EXPECT_NEAR(*none.summary.deviation, 1.581139, 1e-6);
  // 2.776445 by 1.581139 / sqrt(5).
  EXPECT_NEAR(none.summary.interval->low, 77 - 1.963243, 1e-5);
}

/// Worked by hand. Of the 32 sign patterns 2 are as extreme as 1, 2, 3, 4, 5; 4 as -1, 2, 3, 4, 5;
/// and 10 as -1, -2, 3, 4, 5. Holm counts these three, without the ceiling: 3, 2 and 1 times p.
/// Half-widths: 2.776445 times the deviations 1.581139, 2.302173, 3.114482 / sqrt(5).
TEST(TransferGroup, MatchesHandCalculation) {
  EXPECT_EQ(transfer_comparisons_csv(transfer_group(choices, two_datasets())),
            "group,ratio,method,classifier,minus,minus_classifier,seeds,mean_difference,ci95_low,"
            "ci95_high,rank_biserial,p,p_holm\n"
            "g,1to1,strike-twin,wdcnn-spectra,none,wdcnn,5,3.0000,1.0368,4.9632,1.0000,0.0625,"
            "0.1875\n"
            "g,1to1,strike-twin,wdcnn-spectra,shift,wdcnn,5,2.6000,-0.2585,5.4585,0.8667,0.125,"
            "0.25\n"
            "g,1to1,strike-twin,wdcnn-spectra,oracle,wdcnn,5,-20.0000,-20.0000,-20.0000,-1.0000,"
            "0.0625,\n"
            "g,1to1,strike-twin,wdcnn-spectra,none,nearest,5,1.8000,-2.0671,5.6671,0.6000,0.3125,"
            "0.3125\n");
}

/// All classifiers without training are compared, next to the method's recorded input.
TEST(TransferGroup, ComparesWithEachClassifierWithoutTraining) {
  std::vector<DatasetRows> datasets = two_datasets();
  for (DatasetRows& each : datasets) {
    AccuracyRow row = row_by("nearest-orders", row_with("none", "100to1", {83, 84, 83, 84, 83}));
    row.dataset = each.dataset;
    each.rows.push_back(std::move(row));
    row = row_by("nearest-orders", row_with("shift", "1to1", {50, 50, 50, 50, 50}));
    row.dataset = each.dataset;
    each.rows.push_back(std::move(row));
  }
  const TransferGroup group = transfer_group(choices, datasets);
  std::vector<std::string> references;
  for (const GroupRow* const row : group.references()) references.push_back(row->classifier);
  EXPECT_THAT(references, ElementsAre("nearest", "nearest-orders"));
  ASSERT_EQ(group.differences.size(), 5U);
  EXPECT_EQ(group.differences.back().method, "none by nearest-orders");
  EXPECT_NEAR(group.differences.back().paired.difference.mean, -3.4, 1e-9);
  EXPECT_THAT(markdown(transfer_document(group)), HasSubstr("| none by nearest-orders | –"));
}

/// A method's best classifier may be one without training. A reference that was chosen is shown
/// once.
TEST(TransferGroup, ShowsAChosenReferenceOnce) {
  std::vector<DatasetRows> datasets = two_datasets();
  GroupChoices nearest = choices;
  nearest.inputs.front().classifier = "nearest";
  const TransferGroup group = transfer_group(nearest, datasets);
  EXPECT_EQ(group.recorded().front()->classifier, "nearest");
  EXPECT_THAT(group.references(), testing::IsEmpty());
  EXPECT_EQ(group.differences.front().method, "none");
  EXPECT_NEAR(group.differences.front().paired.difference.mean, 1.8, 1e-9);
  EXPECT_THAT(transfer_csv(group),
              HasSubstr("mean,,none,method,nearest,1,0,100to1,1,82.0000,,,,,,,,1,0\n"));
}

TEST(TransferGroup, ShowsChoicesAndReferencesWithoutRules) {
  EXPECT_TRUE(choices.shows("none", "wdcnn"));
  EXPECT_FALSE(choices.shows("none", "wdcnn-spectra"));
  EXPECT_TRUE(choices.shows("none", "nearest-orders"));
  EXPECT_FALSE(choices.shows("shift", "nearest-orders"));
  GroupChoices both = choices;
  both.type_inputs = {{"shift", "nearest-orders"}, {"none", "wdcnn-orders"}};
  EXPECT_TRUE(both.shows("shift", "nearest-orders"));
  EXPECT_THAT(both.classifiers(),
              ElementsAre("wdcnn", "wdcnn-spectra", "nearest", "wdcnn-orders", "nearest-orders"));
}

TEST(TransferGroup, MarksTheRecordedAndTheBestInput) {
  const TransferGroup group = transfer_group(choices, two_datasets());
  EXPECT_EQ(group.best_of("none")->classifier, "wdcnn-spectra");
  EXPECT_FALSE(group.best_of("none")->by_class.recorded);
  EXPECT_TRUE(group.best_of("shift")->by_class.recorded);
  const std::string csv = transfer_csv(group);
  for (const std::string line :
       {"dataset,speed_ratio,method,role,classifier,recorded,best,ratio,seed,accuracy,",
        "a,0.7500,none,method,wdcnn,1,0,100to1,0,80.0000,,,,,,,,1,0\n",
        "mean,,none,method,wdcnn,1,0,100to1,mean,77.0000,1.5811,75.0368,78.9632,,,,,1,0\n",
        "mean,,none,method,wdcnn-spectra,0,1,100to1,4,79.0000,,,,,,,,0,0\n",
        "mean,,none,bar,nearest,0,0,100to1,1,82.0000,,,,,,,,0,0\n",
        "mean,,vae,method,wdcnn,0,1,1to1,0,9.0000,,,,,,,,0,0\n",
        "b,0.7500,strike-twin,against,wdcnn-spectra,1,1,1to1,1,90.0000,,,,,,,,1,0\n",
        "mean,,oracle,ceiling,wdcnn,1,1,1to1,mean,100.0000,0.0000,100.0000,100.0000,,,,,1,0\n"}) {
    EXPECT_THAT(csv, HasSubstr(line));
  }
}

TEST(TransferGroup, WritesMarkdown) {
  const std::string text = markdown(transfer_document(transfer_group(choices, two_datasets())));
  EXPECT_THAT(text, testing::StartsWith("# Faults known in another condition: g\n"));
  EXPECT_THAT(
      text,
      HasSubstr("[transfer.g] of pipeline/protocol.toml does not record a classifier for vae"));
  EXPECT_THAT(
      text, HasSubstr("| method           | shown         |      accuracy |    95 % interval |\n"
                      "|------------------|---------------|--------------:|-----------------:|\n"
                      "| none             | wdcnn         |  77.00 ± 1.58 |   [75.04, 78.96] |\n"
                      "| strike-twin      | wdcnn-spectra |  80.00 ± 0.00 |   [80.00, 80.00] |\n"));
  EXPECT_THAT(text, HasSubstr("| none by nearest  | –             |  78.20 ± 3.11 |"));
  EXPECT_THAT(text, HasSubstr("## Mean of strike-twin minus that of each other, points\n"));
  EXPECT_THAT(text, HasSubstr("| shift            | 1:1   |  +2.60 ± 2.30 |"));
  EXPECT_THAT(text,
              HasSubstr("| none             | wdcnn         |  74.60 ± 4.45 |  79.40 ± 1.95 |\n"));
  EXPECT_THAT(text,
              HasSubstr("| none             |   77.00 ✓ |       79.00 ↑ |   78.20 | 2.00 |\n"));
  EXPECT_THAT(text,
              HasSubstr("| vae              |    9.00 ↑ |             – |       – |    – |\n"));
  EXPECT_THAT(text, HasSubstr("inputs = [\"none=wdcnn-spectra\",\n\"vae=wdcnn\", "));
  EXPECT_THAT(text, Not(HasSubstr("by fault type")));
}

TEST(TransferGroup, MarksClassifiersThatSeeD) {
  std::vector<DatasetRows> rows = two_datasets();
  for (DatasetRows& each : rows) {
    AccuracyRow row = row_by("cdan", row_with("shift", "1to1", {99, 99, 99, 99, 99}));
    row.dataset = each.dataset;
    each.rows.push_back(row);
  }
  const std::string text = markdown(transfer_document(transfer_group(choices, rows)));
  EXPECT_THAT(text, HasSubstr(" cdan (sees D) |"));
  EXPECT_THAT(text, HasSubstr("A classifier that sees D "));
  EXPECT_THAT(markdown(transfer_document(transfer_group(choices, two_datasets()))),
              Not(HasSubstr("sees D")));
}

/// By fault type every method has 100 and 90 on the data sets, mean 95; none by wdcnn has 100.
TEST(TransferGroup, ShowsTheKindOfDefectIfAllDatasetsHaveIt) {
  std::vector<DatasetRows> datasets = two_datasets();
  datasets[0].types = datasets[0].rows;
  for (AccuracyRow& row : datasets[0].types) std::ranges::fill(row.values, 100);
  EXPECT_FALSE(transfer_group(choices, datasets).own()->mean.type_accuracy.has_value());
  datasets[1].types = datasets[1].rows;
  for (AccuracyRow& row : datasets[1].types) std::ranges::fill(row.values, 90);
  std::ranges::fill(datasets[1].types.front().values, 100);
  const TransferGroup group = transfer_group(choices, datasets);
  EXPECT_EQ(group.own()->mean.type_accuracy->summary.mean, 95);
  EXPECT_THAT(transfer_csv(group),
              HasSubstr("mean,,shift,method,wdcnn,1,1,1to1,0,81.0000,,,,95.0000,,,,1,1\n"));
  const std::string text = markdown(transfer_document(group));
  EXPECT_THAT(text, HasSubstr("## Mean over the data sets by fault type, percent\n"));
  EXPECT_THAT(text, HasSubstr("95.00 ± 0.00 |   [95.00, 95.00] |"));
  EXPECT_THAT(text,
              HasSubstr("| none             | 100.00 ✓↑ |         95.00 |   95.00 | 0.00 |\n"));
}

TEST(TransferGroup, UsesASeparateInputForEachQuestion) {
  std::vector<DatasetRows> datasets = two_datasets();
  for (DatasetRows& each : datasets) each.types = each.rows;
  GroupChoices both = choices;
  both.type_inputs = choices.inputs;
  both.type_inputs.front().classifier = "wdcnn-spectra";
  const TransferGroup group = transfer_group(both, datasets);
  EXPECT_EQ(group.recorded().front()->classifier, "wdcnn");
  EXPECT_EQ(group.recorded(Question::by_type).front()->classifier, "wdcnn-spectra");
  const std::string text = markdown(transfer_document(group));
  EXPECT_THAT(text, HasSubstr("| none             | wdcnn-spectra |  79.00 ± 0.00 |"));
  EXPECT_THAT(text, HasSubstr("but chosen for fault types."));
  EXPECT_THAT(markdown(transfer_document(transfer_group(choices, datasets))),
              HasSubstr("Shown: as above."));
  EXPECT_THAT(
      transfer_csv(group),
      HasSubstr("a,0.7500,none,method,wdcnn-spectra,0,1,100to1,0,79.0000,,,,79.0000,,,,1,1\n"));
}

TEST(TransferGroup, SubtractsNothingWithoutItsMethod) {
  std::vector<DatasetRows> datasets = two_datasets();
  for (DatasetRows& each : datasets) {
    std::erase_if(each.rows, [](const AccuracyRow& row) { return row.method == "strike-twin"; });
  }
  const TransferGroup group = transfer_group(choices, datasets);
  EXPECT_TRUE(group.differences.empty());
  EXPECT_THAT(
      markdown(transfer_document(group)),
      HasSubstr(
          "strike-twin by its own classifier is not among these cells, so nothing is subtracted"));
}

TEST(TransferGroup, NeedsTheSameSeedsForAllDatasets) {
  std::vector<DatasetRows> datasets = two_datasets();
  for (AccuracyRow& row : datasets[1].rows) row.seeds = {0, 1, 2, 3, 5};
  EXPECT_ERROR(transfer_group(choices, datasets), Exit::bad_input,
               "none: b has the seeds 0 to 3, 5, but a has 0 to 4; a mean over data sets needs");
}

TEST(TransferGroup, IsAtMost100Wide) {
  std::vector<DatasetRows> datasets;
  for (const std::string name : {"hit-sm-1200to900", "hit-sm-1200to600", "hit-sm-600to1200"}) {
    std::vector<AccuracyRow> rows;
    for (const std::string classifier :
         {"wdcnn", "wdcnn-spectrum", "wdcnn-envelope", "wdcnn-spectra", "nearest"}) {
      rows.push_back(row_by(classifier, row_with("none", "100to1", {100, 0, 20})));
      for (const std::string method : {"piae-dt-phase", "strike-twin", "oracle"}) {
        rows.push_back(row_by(classifier, row_with(method, "1to1", {100, 30, 100})));
      }
    }
    datasets.push_back(dataset_of(name, rows));
    datasets.back().types = datasets.back().rows;
  }
  std::istringstream lines(markdown(transfer_document(transfer_group(choices, datasets))));
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(width_of(line), 100U) << line;
  }
}

/// A run of two data sets at two seeds: none by wdcnn and nearest, and smote by wdcnn.
class TransferOfARun : public StoredRun {
 protected:
  TransferOfARun() : StoredRun("one") {
    for (const std::string dataset : {"one", "two"}) {
      for (const int seed : {0, 1}) {
        add_to(dataset, diagnosis("none", "100to1", 0, seed, 12));
        add_to(dataset, by("nearest", diagnosis("none", "100to1", 0, seed, 10)));
        add_to(dataset, diagnosis("smote", "1to1", 495, seed, dataset == "one" ? 16 : 18));
      }
    }
  }
  void add_to(const std::string& dataset, scoring::DiagnosisRecord record) const {
    record.info.name = dataset;
    save("diagnosis", record,
         run::Layout(run_, dataset)
             .diagnosis(record.method, record.ratio, record.seed, record.classifier));
  }
  [[nodiscard]] TransferGroup read() const { return read_transfer(run_, options_); }

  const std::filesystem::path run_ = folder_.path() / "run";
  TransferOptions options_{.group = "g",
                           .datasets = {"one two"},
                           .against = "smote",
                           .inputs = {"none=wdcnn smote=wdcnn"},
                           .methods = {"none smote"},
                           .ratio = "1to1",
                           .classifiers = {"wdcnn"},
                           .seeds = {"0 1"}};
};

/// 16 and 18 of 20 are 80 and 90 percent.
TEST_F(TransferOfARun, AveragesOverBothDatasets) {
  const TransferGroup group = read();
  EXPECT_EQ(group.rows.size(), 3U);
  EXPECT_THAT(group.own()->mean.row.values, ElementsAre(85, 85));
  EXPECT_THAT(group.differences[0].differences, ElementsAre(25, 25));
  EXPECT_THAT(group.differences[1].differences, ElementsAre(35, 35));
}

/// smote by nearest does not exist, and is not needed.
TEST_F(TransferOfARun, ReadsTheShownCellsIfNoClassifierIsRequested) {
  options_.classifiers = {};
  for (const std::string dataset : {"one", "two"}) {
    for (const int seed : {0, 1}) {
      add_to(dataset, by("nearest-orders", diagnosis("none", "100to1", 0, seed, 11)));
    }
  }
  const TransferGroup group = read();
  EXPECT_EQ(group.rows.size(), 4U);
  EXPECT_EQ(group.references().size(), 2U);
  EXPECT_THAT(group.own()->mean.row.values, ElementsAre(85, 85));
}

TEST_F(TransferOfARun, NeedsEveryCellOfEveryDataset) {
  const run::Layout two(run_, "two");
  std::filesystem::remove(two.diagnosis("smote", "1to1", 1));
  EXPECT_ERROR(read(), Exit::input_missing, "1 of the files that the tables need is missing");
  save("diagnosis", diagnosis("smote", "1to1", 495, 1, 12), two.diagnosis("smote", "1to1", 1));
  EXPECT_ERROR(read(), Exit::bad_input,
               "1 of the files that the tables need is missing or refused; no table was written "
               "(make the cells named above, or request fewer)");
}

TEST_F(TransferOfARun, RefusesInvalidOptions) {
  const TransferOptions good = options_;
  const auto refused = [&](const std::string& what) {
    EXPECT_ERROR(read(), Exit::usage, what);
    options_ = good;
  };
  options_.ratio = "100to1";
  refused("--ratio 100to1: no window is generated there");
  options_.inputs = {"none=wdcnn", "none=wdcnn-spectra"};
  refused("--inputs: names an input of none twice");
  options_.type_inputs = {"none=wdcnn"};
  refused("--kind-inputs: must name one input for each method of --inputs");
  options_.inputs = {"none=cnn"};
  refused("'none=cnn' names an unknown classifier");
  options_.classifiers = {"wdcnn cnn"};
  refused("unknown classifier 'cnn'; known: wdcnn, ");
}

TEST_F(TransferOfARun, RefusesDatasetsOfOtherSplits) {
  for (const int seed : {0, 1}) {
    for (scoring::DiagnosisRecord record : {diagnosis("none", "100to1", 0, seed, 12),
                                            by("nearest", diagnosis("none", "100to1", 0, seed, 10)),
                                            diagnosis("smote", "1to1", 495, seed, 3)}) {
      record.protocol = signal::Protocol::blocked;
      add_to("two", record);
    }
  }
  EXPECT_ERROR(read(), Exit::bad_input, "two: the split is blocked, and random of one");
}

}  // namespace
}  // namespace piae::report
