#include "run/collect.hpp"

#include "base/error.hpp"
#include "support/stored_run.hpp"

namespace piae::run {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

class Cells : public StoredRun {
 protected:
  void expect_problem(const std::string& what, Exit exit) {
    const Results results = collect(layout_, grid_);
    EXPECT_THAT(results.problems, ElementsAre(HasSubstr(what)));
    EXPECT_EQ(results.exit, exit);
  }
  void expect_missing(const std::filesystem::path& cell, const std::string& log) {
    EXPECT_EQ(Layout::unfinished_log(cell), std::filesystem::path(log));
  }
  /// Leaves a trace of a step in the run.
  void touch(const std::filesystem::path& file) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << "x";
  }
};

TEST_F(Cells, AreInTheFoldersOfTheGrid) {
  const Layout layout("results/try", "cwru");
  EXPECT_EQ(layout.diagnosis("vae", "10to1", 3),
            "results/try/cwru/seed3/vae/10to1/wdcnn/diagnosis.h5");
  EXPECT_EQ(layout.score("vae", 3), "results/try/cwru/seed3/vae/score.h5");
  EXPECT_EQ(layout.accuracy_csv(), "results/try/cwru/accuracy.csv");
  EXPECT_EQ(layout.gains_csv(), "results/try/cwru/gains.csv");
  EXPECT_EQ(layout.quality_csv(), "results/try/cwru/quality.csv");
  EXPECT_EQ(layout.tables_markdown(), "results/try/cwru/tables.md");
  EXPECT_EQ(layout.tables_latex(), "results/try/cwru/tables.tex");
}

TEST_F(Cells, AreAllFound) {
  add_all();
  const Results results = collect(layout_, grid_);
  EXPECT_THAT(results.problems, ElementsAre());
  EXPECT_EQ(results.exit, Exit::done);
  EXPECT_EQ(results.diagnoses.size(), 6U);
  EXPECT_EQ(results.qualities.size(), 2U);
}

/// 900 rpm tested, 1200 known: 0.75. Empty if every fault is tested in its known condition.
TEST_F(Cells, GiveTheRatioOfTestedToKnownSpeed) {
  scoring::DiagnosisRecord record = diagnosis("none", "100to1", 0, 0, 12);
  const auto speed_ratio = [&] {
    add(record);
    return collect(layout_, grid("none", "100to1", "0")).diagnoses.at(0).speed_ratio;
  };
  EXPECT_EQ(speed_ratio(), std::nullopt);
  record.info.conditions = {{"900 rpm", 900, false, true, true},
                            {"1200 rpm", 1200, true, false, true}};
  EXPECT_EQ(speed_ratio(), 0.75);
  for (signal::Condition& each : record.info.conditions) each.known = each.test = true;
  EXPECT_EQ(speed_ratio(), std::nullopt);
}

TEST_F(Cells, AreNamedIfMissing) {
  add_all();
  std::filesystem::remove(layout_.diagnosis("none", "100to1", 1));
  std::filesystem::remove(layout_.diagnosis("vae", "2to1", 0));
  std::filesystem::remove(layout_.score("vae", 0));
  const Results results = collect(layout_, grid_);
  EXPECT_THAT(
      results.problems,
      ElementsAre(AllOf(StartsWith("method none, ratio 100to1, seed 1: "),
                        HasSubstr("cwru/seed1/none/100to1/wdcnn/diagnosis.h5: No such file")),
                  AllOf(StartsWith("method vae, ratio 2to1, seed 0: "),
                        HasSubstr("cwru/seed0/vae/2to1/wdcnn/diagnosis.h5: No such file")),
                  AllOf(StartsWith("method vae, seed 0: "),
                        HasSubstr("cwru/seed0/vae/score.h5: No such file"))));
  EXPECT_EQ(results.exit, Exit::input_missing);
}

TEST_F(Cells, AreNamedWithTheirLogIfFailed) {
  add_all();
  const auto cell = layout_.diagnosis("vae", "2to1", 0);
  const auto log = cell.parent_path() / "diagnose.log";
  std::filesystem::remove(cell);
  touch(log);
  const Results results = collect(layout_, grid_);
  EXPECT_THAT(
      results.problems,
      ElementsAre(EndsWith("; a step before it failed or is missing, see " + log.string())));
  EXPECT_EQ(results.exit, Exit::input_missing);
}

TEST_F(Cells, AreMissingBecauseOfTheFirstStepWithoutAResult) {
  const auto score = layout_.score("vae", 0);
  const auto diagnosis = layout_.diagnosis("vae", "2to1", 0);
  const auto method = score.parent_path();
  EXPECT_EQ(Layout::unfinished_log(score), std::nullopt);
  touch(method / "score.log");  // unrelated to the diagnosis
  EXPECT_EQ(Layout::unfinished_log(diagnosis), std::nullopt);
  expect_missing(score, method / "score.log");
  touch(diagnosis.parent_path() / "diagnose.log");
  expect_missing(diagnosis, diagnosis.parent_path() / "diagnose.log");
  touch(method / "generate.log");
  expect_missing(diagnosis, method / "generate.log");
  touch(method / "train.log");
  expect_missing(diagnosis, method / "train.log");
  expect_missing(score, method / "train.log");
  touch(method.parent_path() / "split.log");
  expect_missing(score, method.parent_path() / "split.log");
  for (const char* made : {"D.h5", "vae/model.h5", "vae/E.h5"}) touch(method.parent_path() / made);
  expect_missing(score, method / "score.log");
}

TEST_F(Cells, GiveDamagedFilesPriorityOverMissingOnes) {
  add_all();
  std::filesystem::remove(layout_.score("vae", 0));
  std::filesystem::remove(layout_.score("vae", 1));
  std::filesystem::resize_file(layout_.diagnosis("vae", "2to1", 0), 1000);
  const Results results = collect(layout_, grid_);
  EXPECT_EQ(results.problems.size(), 3U);
  EXPECT_EQ(results.exit, Exit::bad_input);
}

TEST_F(Cells, AreRefusedInTheWrongPlace) {
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
  expect_refused(other, "the data set is hit-sm, here it must be cwru");
}

TEST_F(Cells, AreRefusedIfTheyDoNotBelongTogether) {
  add_all();
  scoring::DiagnosisRecord other = diagnosis("vae", "2to1", 145, 1, 9);
  other.protocol = signal::Protocol::blocked;
  add(other);
  expect_problem("the split protocol is blocked, here it must be random", Exit::bad_input);
  add(diagnosis("vae", "2to1", 95, 1, 9));
  expect_problem("the number of generated windows per class is 95, here it must be 145",
                 Exit::bad_input);
  other = diagnosis("vae", "2to1", 145, 1, 9);
  other.true_ratio = 2;
  add(other);
  expect_problem("the true ratio is 2.000000, here it must be 3.333333", Exit::bad_input);
  other = diagnosis("vae", "2to1", 145, 1, 9);
  other.any_known = false;
  add(other);
  expect_problem("the number of known windows is zero, here it must be above zero",
                 Exit::bad_input);
  other = diagnosis("vae", "2to1", 145, 1, 9);
  other.info.classes.push_back({"Ball", signal::Defect::roller, 0.2});
  other.scores.resize(80);
  add(other);
  expect_problem("the list of classes is Normal IR OR Ball, here it must be Normal IR OR",
                 Exit::bad_input);
}

TEST_F(Cells, AreRefusedIfTheirScoresDoNotBelongTogether) {
  add_all();
  scoring::QualityRecord other = quality("vae", 1, 0.5);
  other.classes.pop_back();
  add(other);
  expect_problem("the list of classes is IR, here it must be IR OR", Exit::bad_input);
  other = quality("vae", 1, 0.5);
  other.protocol = signal::Protocol::blocked;
  add(other);
  expect_problem("the split protocol is blocked, here it must be random", Exit::bad_input);
  save("score", quality("vae", 0, 0.5), layout_.score("vae", 1));
  expect_problem("the seed is 0, here it must be 1", Exit::bad_input);
}

}  // namespace
}  // namespace piae::run
