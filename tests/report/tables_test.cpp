#include <gmock/gmock.h>

#include <fstream>

#include "base/error.hpp"
#include "report/accuracy_table.hpp"
#include "report/markdown.hpp"
#include "report/quality_table.hpp"
#include "scoring/diagnosis_record.hpp"
#include "scoring/sets.hpp"

namespace piae::report {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// A run in a temporary folder: dataset cwru with three classes and 20 windows in A.
class Tables : public testing::Test {
 protected:
  Tables() {
    write_text("table6-7-baseline.csv", "dataset,run1,run2,run3,average\ncwru,61.8,62,61.7,61.8\n");
    write_text("table8-9-methods.csv", "dataset,method,2to1\ncwru,vae,91.2\n");
    write_text("table10-11-ablation.csv", "dataset,model,2to1\ncwru,model2,91.7\n");
  }
  void write_text(const std::string& name, const std::string& text) {
    std::ofstream(folder_.path() / name) << text;
  }

  static scoring::DiagnosisRecord diagnosis(const std::string& method, const std::string& ratio,
                                            int generated, int seed, int right) {
    scoring::DiagnosisRecord record;
    record.info = testing_sets::three_classes(dataset);
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
  static scoring::QualityRecord quality(const std::string& method, int seed, double value) {
    return {testing_sets::three_classes(dataset),
            method,
            seed,
            "random",
            {{1, 9, value, 2 * value, 3, 4, 5}, {2, 9, 1e-7, 1, 1, 1, 1}}};
  }
  template <class Record>
  static void save(const std::string& kind, const Record& record,
                   const std::filesystem::path& path) {
    artefact::Writer writer(kind);
    scoring::write(writer, record);
    writer.save(path, {"test", "", {}});
  }
  void add(const scoring::DiagnosisRecord& record) {
    save("diagnosis", record, layout_.diagnosis(record.method, record.ratio, record.seed));
  }
  void add(const scoring::QualityRecord& record) {
    save("score", record, layout_.score(record.method, record.seed));
  }
  void add_all() {
    add(diagnosis("none", "100to1", 0, 0, 12));
    add(diagnosis("none", "100to1", 0, 1, 13));
    add(diagnosis("vae", "10to1", 45, 0, 15));
    add(diagnosis("vae", "10to1", 45, 1, 15));
    add(diagnosis("vae", "2to1", 145, 0, 17));
    add(diagnosis("vae", "2to1", 145, 1, 19));
    add(quality("vae", 0, 0.5));
    add(quality("vae", 1, 0.7));
  }
  void expect_problem(const std::string& what, Exit exit) {
    const Results results = collect(layout_, grid_);
    EXPECT_THAT(results.problems, ElementsAre(HasSubstr(what)));
    EXPECT_EQ(results.exit, exit);
  }

  static constexpr const char* dataset = "cwru";
  testing_sets::TemporaryFolder folder_;
  const Layout layout_{folder_.path() / "run", dataset};
  const Grid grid_ = resolve({dataset, {"none vae"}, {"100to1 10to1 2to1"}, {"0 1"}});
};

TEST_F(Tables, LieWhereTheGridKeepsThem) {
  const Layout layout("results/try", "cwru");
  EXPECT_EQ(layout.diagnosis("vae", "10to1", 3), "results/try/cwru/seed3/vae/10to1/diagnosis.h5");
  EXPECT_EQ(layout.score("vae", 3), "results/try/cwru/seed3/vae/score.h5");
  EXPECT_EQ(layout.accuracy_csv(), "results/try/cwru/accuracy.csv");
  EXPECT_EQ(layout.quality_csv(), "results/try/cwru/quality.csv");
  EXPECT_EQ(layout.tables_markdown(), "results/try/cwru/tables.md");
}

/// Of two values a, b the deviation is |a - b| / sqrt(2), and the interval's half 12.7062 |a - b|
/// / 2.
TEST_F(Tables, OfTwoSeeds) {
  add_all();
  const Results results = collect(layout_, grid_);
  EXPECT_THAT(results.problems, ElementsAre());
  EXPECT_EQ(results.exit, Exit::done);
  const Published published(folder_.path());
  const auto rows = accuracy_rows(grid_, results, published);
  EXPECT_EQ(accuracy_csv(rows),
            "dataset,method,ratio,generated_per_class,seeds,mean,std,ci95_low,ci95_high,published\n"
            "cwru,none,100to1,0,2,62.5000,3.5355,30.7345,94.2655,61.8\n"
            "cwru,vae,10to1,45,2,75.0000,0.0000,75.0000,75.0000,\n"
            "cwru,vae,2to1,145,2,90.0000,7.0711,26.4690,153.5310,91.2\n");
  EXPECT_EQ(quality_csv(grid_, results),
            "dataset,method,class,metric,seeds,mean,std\n"
            "cwru,vae,IR,mmd,2,0.6,0.141421\n"
            "cwru,vae,IR,rmse,2,1.2,0.282843\n"
            "cwru,vae,IR,aligned_rmse,2,3,0\n"
            "cwru,vae,IR,amplitude_ratio,2,4,0\n"
            "cwru,vae,IR,spectral_distance_db,2,5,0\n"
            "cwru,vae,OR,mmd,2,1e-07,0\n"
            "cwru,vae,OR,rmse,2,1,0\n"
            "cwru,vae,OR,aligned_rmse,2,1,0\n"
            "cwru,vae,OR,amplitude_ratio,2,1,0\n"
            "cwru,vae,OR,spectral_distance_db,2,1,0\n");
  EXPECT_EQ(accuracy_text(rows),
            "method  ratio         generated  seeds    accuracy %    95 % interval  paper\n"
            "none    100:1                 0      2  62.50 ± 3.54   [30.73, 94.27]   61.8\n"
            "vae     10:1                 45      2  75.00 ± 0.00   [75.00, 75.00]\n"
            "vae     2:1 (3.33:1)        145      2  90.00 ± 7.07  [26.47, 153.53]   91.2\n");
  EXPECT_THAT(
      tables_markdown(grid_, results, rows, published),
      AllOf(
          StartsWith("# Diagnostic accuracy on cwru\n\nPercent. Split protocol `random`; 2 seeds"),
          HasSubstr("\n## Without augmentation, 100:1 (the paper's Table 6)\n\n"
                    "|                 | run 1 | run 2 | run 3 |         mean |  95 % interval |\n"
                    "|-----------------|------:|------:|------:|-------------:|---------------:|\n"
                    "| here, seeds 0 1 | 60.00 | 65.00 |       | 62.50 ± 3.54 | [30.73, 94.27] |\n"
                    "| paper           | 61.80 | 62.00 | 61.70 |        61.80 |                |\n"
                    "\n## With augmentation (the paper's Table 8)\n\n"
                    "| method |       |           10:1 |    2:1 (3.33:1) |\n"
                    "|--------|-------|---------------:|----------------:|\n"
                    "| vae    | here  |   75.00 ± 0.00 |    90.00 ± 7.07 |\n"
                    "|        | 95 %  | [75.00, 75.00] | [26.47, 153.53] |\n"
                    "|        | paper |                |           91.20 |\n")));
}

TEST_F(Tables, OfOneSeedHaveNoSpread) {
  add_all();
  const Grid grid = resolve({dataset, {"none vae"}, {"100to1 10to1"}, {"1"}});
  const Results results = collect(layout_, grid);
  const Published published(folder_.path());
  const auto rows = accuracy_rows(grid, results, published);
  EXPECT_THAT(accuracy_csv(rows), HasSubstr("\ncwru,none,100to1,0,1,65.0000,,,,61.8\n"
                                            "cwru,vae,10to1,45,1,75.0000,,,,\n"));
  EXPECT_THAT(quality_csv(grid, results), HasSubstr("\ncwru,vae,IR,mmd,1,0.7,\n"));
  EXPECT_THAT(
      tables_markdown(grid, results, rows, published),
      AllOf(HasSubstr("1 seed,"), HasSubstr("| here, seed 1 | 65.00 |       |       | 65.00 |"),
            HasSubstr("| vae    | here | 75.00 |\n")));
}

TEST_F(Tables, OfOneSideOfTheGridOnly) {
  add_all();
  const Published published(folder_.path());
  const auto markdown = [&](const std::string& methods) {
    const Grid grid = resolve({dataset, {methods}, {"100to1 10to1"}, {"0 1"}});
    const Results results = collect(layout_, grid);
    return tables_markdown(grid, results, accuracy_rows(grid, results, published), published);
  };
  EXPECT_THAT(markdown("none"), testing::Not(HasSubstr("## With augmentation")));
  EXPECT_THAT(markdown("vae"), testing::Not(HasSubstr("## Without augmentation")));
  EXPECT_EQ(quality_csv(resolve({dataset, {"none"}, {"100to1"}, {"0"}}), {}),
            "dataset,method,class,metric,seeds,mean,std\n");
}

TEST_F(Tables, EveryMissingCellIsNamed) {
  add_all();
  std::filesystem::remove(layout_.diagnosis("none", "100to1", 1));
  std::filesystem::remove(layout_.diagnosis("vae", "2to1", 0));
  std::filesystem::remove(layout_.score("vae", 0));
  const Results results = collect(layout_, grid_);
  EXPECT_THAT(results.problems,
              ElementsAre(HasSubstr("cwru/seed1/none/100to1/diagnosis.h5: No such file"),
                          HasSubstr("cwru/seed0/vae/2to1/diagnosis.h5: No such file"),
                          HasSubstr("cwru/seed0/vae/score.h5: No such file")));
  EXPECT_EQ(results.exit, Exit::input_missing);
}

TEST_F(Tables, DamageOutweighsAbsence) {
  add_all();
  std::filesystem::remove(layout_.score("vae", 0));
  std::filesystem::remove(layout_.score("vae", 1));
  std::filesystem::resize_file(layout_.diagnosis("vae", "2to1", 0), 1000);
  const Results results = collect(layout_, grid_);
  EXPECT_EQ(results.problems.size(), 3U);
  EXPECT_EQ(results.exit, Exit::bad_input);
}

TEST_F(Tables, CellInTheWrongPlaceIsRefused) {
  const auto path = layout_.diagnosis("vae", "2to1", 1);
  const auto expect_refused = [&](const scoring::DiagnosisRecord& record, const std::string& what) {
    add_all();
    save("diagnosis", record, path);
    expect_problem(what, Exit::bad_input);
  };
  expect_refused(diagnosis("ae", "2to1", 145, 1, 9), "the method is ae, here it must be vae");
  expect_refused(diagnosis("vae", "1to1", 145, 1, 9), "the ratio is 1to1, here it must be 2to1");
  expect_refused(diagnosis("vae", "2to1", 145, 0, 9), "the seed is 0, here it must be 1");
  scoring::DiagnosisRecord other = diagnosis("vae", "2to1", 145, 1, 9);
  other.info.name = "hit-sm";
  expect_refused(other, "the dataset is hit-sm, here it must be cwru");
}

TEST_F(Tables, CellsThatDoNotBelongTogetherAreRefused) {
  add_all();
  scoring::DiagnosisRecord other = diagnosis("vae", "2to1", 145, 1, 9);
  other.protocol = "blocked";
  add(other);
  expect_problem("the split protocol is blocked, here it must be random", Exit::bad_input);
  add(diagnosis("vae", "2to1", 95, 1, 9));
  expect_problem("the number of generated windows per class is 95, here it must be 145",
                 Exit::bad_input);
  other = diagnosis("vae", "2to1", 145, 1, 9);
  other.true_ratio = 2;
  add(other);
  expect_problem("the true ratio is 2.000000, here it must be 3.333333", Exit::bad_input);
}

TEST_F(Tables, ScoresThatDoNotBelongTogetherAreRefused) {
  add_all();
  scoring::QualityRecord other = quality("vae", 1, 0.5);
  other.classes.pop_back();
  add(other);
  expect_problem("the list of classes is IR, here it must be IR OR", Exit::bad_input);
  other = quality("vae", 1, 0.5);
  other.protocol = "blocked";
  add(other);
  expect_problem("the split protocol is blocked, here it must be random", Exit::bad_input);
  save("score", quality("vae", 0, 0.5), layout_.score("vae", 1));
  expect_problem("the seed is 0, here it must be 1", Exit::bad_input);
}

}  // namespace
}  // namespace piae::report
