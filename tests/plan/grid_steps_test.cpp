#include "plan/grid_steps.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "plan/planned.hpp"
#include "plan/small_run.hpp"
#include "plan/words.hpp"
#include "support/errors.hpp"

namespace piae::plan {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

class StepsOfARun : public testing::Test {
 protected:
  StepsOfARun() {
    run_.request.datasets = "real";
    run_.request.seeds = "0";
  }

  /// Returns the command of the step that makes a file of results/t/real/.
  std::string command(const std::string& file, const std::string& goals = "all") {
    Plan& plan = run_.plan(goals);
    const auto maker = plan.graph().maker_of("results/t/real/" + file);
    return maker ? spaced(command_of(plan.graph().at(*maker))) : "nothing makes it";
  }
  /// Returns the logs of the requested steps, below results/.
  Words logs(const std::string& goals) {
    Plan& plan = run_.plan(goals);
    Words logs;
    for (const StepId id : plan.requested()) {
      logs.push_back(name_of(plan.graph().at(id)).substr(std::string("results/").size()));
    }
    return logs;
  }
  /// Returns the number of requested steps for each name of a log.
  std::map<std::string, int> counts(const std::string& goals) {
    std::map<std::string, int> counts;
    for (const std::string& log : logs(goals)) ++counts[file_name(log)];
    return counts;
  }
  std::string refusal(const std::string& goals) {
    const auto error = error_of([&] { (void)run_.plan(goals); });
    return error ? error->what() : "not refused";
  }

  SmallRun run_;
};

const std::string windows =
    "--test results/t/real/seed0/A.h5 --normal results/t/real/seed0/B.h5 --known "
    "results/t/real/seed0/C.h5 ";

TEST_F(StepsOfARun, GiveEachStageItsFiles) {
  const std::string s = "results/t/.settings/";
  const std::string seed = "results/t/real/seed0";
  EXPECT_EQ(command("records.h5"), "ingest --description " + s +
                                       "datasets/real.toml --data-dir data --output "
                                       "results/t/real/records.h5");
  EXPECT_EQ(command("seed0/smote/E.h5"), "generate --config " + s + "generate.toml --model " +
                                             seed + "/smote/model.h5 --seed 0 --output " + seed +
                                             "/smote/E.h5");
  EXPECT_EQ(command("seed0/smote/score.h5"), "score --config " + s + "score.toml --generated " +
                                                 seed + "/smote/E.h5 --real " + seed +
                                                 "/D.h5 --output " + seed + "/smote/score.h5");
  EXPECT_EQ(command("seed0/smote/10to1/wdcnn/diagnosis.h5"),
            "diagnose --config " + s + "diagnose.toml " + windows + "--generated " + seed +
                "/smote/E.h5 --ratio 10to1 --seed 0 --reproducible --output " + seed +
                "/smote/10to1/wdcnn/diagnosis.h5");
  EXPECT_EQ(command("seed0/none/100to1/nearest/diagnosis.h5"),
            "diagnose --config " + s + "diagnose.toml " + windows +
                "--ratio 100to1 --seed 0 --classifier nearest --reproducible --output " + seed +
                "/none/100to1/nearest/diagnosis.h5");
  EXPECT_THAT(
      command("tables.md"),
      StartsWith("tabulate --config " + s +
                 "tabulate.toml --run results/t --dataset real --methods none smote piae-dt "
                 "--ratios 100to1 10to1 1to1 --seeds 0 --classifiers wdcnn --published "
                 "results/published -- "));
  EXPECT_THAT(logs("tables"), Not(Contains(HasSubstr("made"))));
}

TEST_F(StepsOfARun, DoNotReadRecordingsOfASimulatedDataSet) {
  run_.request.datasets = "made";
  EXPECT_THAT(logs("records"), ElementsAre("t/made/simulate"));
}

TEST_F(StepsOfARun, GiveRealWindowsToTheOracleOnly) {
  run_.request.methods = "smote oracle";
  EXPECT_THAT(command("seed0/oracle/model.h5"), HasSubstr(" --real results/t/real/seed0/D.h5 "));
  EXPECT_THAT(command("seed0/smote/model.h5"), Not(HasSubstr("D.h5")));
  EXPECT_EQ(command("seed0/oracle/score.h5"), "nothing makes it");
}

TEST_F(StepsOfARun, GiveUnlabelledWindowsToClassifiersThatAdapt) {
  run_.request.classifiers = "wdcnn dann";
  EXPECT_THAT(command("seed0/smote/10to1/dann/diagnosis.h5"),
              HasSubstr(" --unlabelled results/t/real/seed0/D.h5 "));
  EXPECT_THAT(command("seed0/smote/10to1/wdcnn/diagnosis.h5"), Not(HasSubstr("D.h5")));
}

TEST_F(StepsOfARun, GiveHealthyWindowsToMethodsThatUseThem) {
  run_.request.methods = "strike-twin";
  EXPECT_THAT(command("seed0/strike-twin/model.h5"),
              HasSubstr(" --healthy results/t/real/seed0/B.h5 "));
}

TEST_F(StepsOfARun, HaveAFolderForEachClassifier) {
  run_.request.methods = "smote";
  run_.request.ratios = "10to1";
  run_.request.classifiers = "wdcnn wdcnn-spectrum";
  EXPECT_THAT(logs("cells"), Contains("t/real/seed0/smote/10to1/wdcnn-spectrum/diagnose"));
  EXPECT_THAT(command("seed0/smote/10to1/wdcnn-spectrum/diagnosis.h5"),
              HasSubstr(" --classifier wdcnn-spectrum "));
  EXPECT_THAT(command("seed0/smote/10to1/wdcnn/diagnosis.h5"), Not(HasSubstr("--classifier ")));
}

TEST_F(StepsOfARun, KeepFeaturesOnceForEachMethodAtTheLowestSeed) {
  run_.request.methods = "none smote oracle";
  run_.request.seeds = "10 2";
  EXPECT_THAT(counts("features"),
              testing::UnorderedElementsAre(testing::Pair("features", 3),
                                            testing::Pair("generate", 2), testing::Pair("train", 2),
                                            testing::Pair("split", 1), testing::Pair("ingest", 1)));
  EXPECT_THAT(command("seed2/smote/1to1/wdcnn/features.h5"), HasSubstr(" --keep-features "));
  EXPECT_THAT(logs("all"), Contains("t/real/seed2/none/100to1/wdcnn/features"));
}

TEST_F(StepsOfARun, DoNotKeepFeaturesOfOtherClassifiers) {
  run_.request.methods = "none smote";
  run_.request.classifiers = "wdcnn-envelope";
  EXPECT_THAT(counts("all"), Not(Contains(testing::Key("features"))));
  EXPECT_EQ(command("seed0/smote/10to1/wdcnn/diagnosis.h5"), "nothing makes it");
  EXPECT_THAT(command("seed0/none/100to1/nearest/diagnosis.h5"), HasSubstr("--classifier nearest"));
}

TEST_F(StepsOfARun, UseAnotherRunForABlockedSplit) {
  run_.request.protocol = signal::Protocol::blocked;
  EXPECT_THAT(logs("records"), ElementsAre("t-blocked/real/ingest"));
  Plan& plan = run_.plan("cells");
  const auto split = plan.graph().maker_of("results/t-blocked/real/seed0/A.h5");
  ASSERT_TRUE(split);
  EXPECT_THAT(spaced(command_of(plan.graph().at(*split))), HasSubstr(" --protocol blocked "));
}

TEST_F(StepsOfARun, CanBeThoseOfOneFile) {
  EXPECT_THAT(logs("results/t/real/seed0/piae-dt/model.h5"),
              ElementsAre("t/real/ingest", "t/real/seed0/split", "t/real/seed0/piae-dt/train"));
  EXPECT_EQ(refusal("results/t/real/seed0/magic/model.h5"),
            "results/t/real/seed0/magic/model.h5: no step makes this file with the given DATASETS, "
            "METHODS, RATIOS, CLASSIFIERS and SEEDS; change these");
}

TEST_F(StepsOfARun, OfAFileDoNotDependOnTheNameOfTheRun) {
  for (const char* name : {"sweep", "mysweep", "readings"}) {
    run_.request.run = name;
    const std::string file =
        "results/" + std::string(name) + "/real/seed0/smote/10to1/wdcnn/diagnosis.h5";
    EXPECT_THAT(logs(file), SizeIs(5));
  }
}

TEST_F(StepsOfARun, MoveOneSettingEachInASweep) {
  run_.request.ratios = std::nullopt;
  run_.set("[diagnose]", "[sweep]\npoints = [\"batch=1\", \"epochs=200\"]\n[diagnose]");
  EXPECT_THAT(command("seed0/sweep/batch-1/model.h5", "sweep"),
              HasSubstr(" --method piae-dt --seed 0 --batch 1 --output "));
  EXPECT_EQ(command("seed0/sweep/epochs-200/model.h5", "sweep"), "nothing makes it");  // the centre
  EXPECT_THAT(
      command("sweep.md", "sweep"),
      HasSubstr(" --centre epochs=200 --run results/t --dataset real --ratios 1to1 --seeds 0"));
  EXPECT_THAT(counts("sweep"), Contains(testing::Pair("train", 2)));
  run_.request.methods = "smote";
  EXPECT_EQ(
      refusal("sweep"),
      "make sweep: METHODS must include one of piae-dt, because only their settings are moved");
  run_.request.methods = "piae-dt none";
  run_.request.ratios = "100to1";
  EXPECT_THAT(refusal("sweep"), HasSubstr("make sweep: RATIOS must include one other than 100to1"));
}

TEST_F(StepsOfARun, NameTheSweepOfAnotherMethodAfterIt) {
  run_.set(
      "[diagnose]",
      "[sweep.smote]\nclassifier = \"wdcnn-spectra\"\npoints = [\"neighbours=1\"]\n[diagnose]");
  EXPECT_THAT(logs("sweep"), Contains("t/real/sweep@smote"));
  EXPECT_THAT(command("seed0/sweep@smote/neighbours-1/1to1/wdcnn-spectra/diagnosis.h5", "sweep"),
              HasSubstr(" --classifier wdcnn-spectra "));
  EXPECT_THAT(command("sweep@smote.csv", "sweep"), HasSubstr(" --method smote "));
}

TEST_F(StepsOfARun, CombineTheBaseWithTheSettingsOfAReading) {
  run_.set("[diagnose]",
           "[readings]\nbase = [\"depth=3\", \"batch=5\"]\nreadings = [\"depth=4\"]\n[diagnose]");
  EXPECT_THAT(command("seed0/readings/depth-4/model.h5", "readings"),
              HasSubstr(" --method piae-dt --seed 0 --depth 4 --batch 5 --output "));
  EXPECT_THAT(command("seed0/readings/base/model.h5", "readings"),
              HasSubstr(" --depth 3 --batch 5 --output "));
  EXPECT_THAT(logs("readings"), Contains("t/real/readings"));
}

TEST_F(StepsOfARun, IdentifyOnlyOnSimulatedDataSets) {
  run_.request.datasets = "real made";
  EXPECT_THAT(command("../made/identifiability.md", "identify"), "nothing makes it");
  EXPECT_THAT(logs("identify"), ElementsAre("t/made/simulate", "t/made/seed0/split",
                                            "t/made/seed0/piae-dt/train", "t/made/identify"));
  run_.request.methods = "smote";
  EXPECT_THAT(refusal("identify"),
              StartsWith("make identify: METHODS must include one of piae-dt "));
  run_.request.methods = "piae-dt";
  run_.request.datasets = "real";
  EXPECT_EQ(refusal("identify"),
            "make identify: DATASETS must include a simulated one (made), because only simulated "
            "(k, c) are known");
}

TEST_F(StepsOfARun, KeepTheClassifierForTrust) {
  run_.request.methods = "smote";
  run_.request.ratios = "10to1";
  EXPECT_THAT(command("seed0/smote/10to1/wdcnn/classifier.h5", "trust"),
              HasSubstr(" --ratio 10to1 --seed 0 --keep-classifier "
                        "results/t/real/seed0/smote/10to1/wdcnn/classifier.h5 -- "));
  EXPECT_THAT(logs("trust"), Contains("t/real/trust"));
}

TEST_F(StepsOfARun, JudgeEachRecordForVerdicts) {
  run_.request.methods = "smote";
  run_.request.ratios = "10to1";
  run_.request.classifiers = "wdcnn";
  EXPECT_THAT(
      command("seed0/smote/10to1/wdcnn/classification.h5", "verdicts"),
      HasSubstr("classify --classifier results/t/real/seed0/smote/10to1/wdcnn/classifier.h5 "
                "--records results/t/real/records.h5 --output "));
  EXPECT_THAT(command("verdicts.md", "verdicts"), Not(HasSubstr("--others")));
  run_.disk.files[run_.pipeline / "datasets/real.csv"] = {.digest = "graded"};
  EXPECT_THAT(command("verdicts.md", "verdicts"), HasSubstr(" --others "));
  EXPECT_THAT(logs("verdicts"), Contains("t/real/verdicts"));
}

TEST_F(StepsOfARun, CoverGroupsOfDataSetsInATransfer) {
  run_.set("[diagnose]",
           "[transfer.both]\ndatasets = [\"real\", \"made\"]\nagainst = \"smote\"\ninputs = "
           "[\"smote=wdcnn-spectra\", \"none=wdcnn\"]\n[diagnose]");
  run_.request.methods = "none smote";
  EXPECT_EQ(refusal("transfer"),
            "make transfer: DATASETS must include all data sets of one group: both (real made)");
  run_.request.datasets = "real made";
  run_.request.classifiers = "wdcnn wdcnn-spectra";
  EXPECT_THAT(logs("transfer"), Contains("t/transfer@both"));
  // Two data sets, each with `none` by two classifiers and nearest, and `smote` by two at one
  // ratio.
  EXPECT_THAT(counts("transfer"), Contains(testing::Pair("diagnose", 10)));
  EXPECT_THAT(counts("transfer"), Not(Contains(testing::Key("score"))));
  Plan& plan = run_.plan("transfer");
  const auto table = plan.graph().maker_of("results/t/transfer@both.md");
  ASSERT_TRUE(table);
  EXPECT_THAT(spaced(command_of(plan.graph().at(*table))),
              HasSubstr(" --group both --methods none smote --ratio 1to1 --seeds 0 --classifiers "
                        "wdcnn wdcnn-spectra "));
  // Without a request: in each data set smote by its choice, and none by its own, by nearest and
  // by nearest-orders.
  run_.request.classifiers.reset();
  EXPECT_THAT(counts("transfer"), Contains(testing::Pair("diagnose", 8)));
}

TEST_F(StepsOfARun, CoverBothSplitsInAContrast) {
  run_.request.methods = "smote";
  run_.request.ratios = "10to1";
  EXPECT_THAT(logs("contrast"), Contains("t-blocked/real/seed0/smote/10to1/wdcnn/diagnose"));
  EXPECT_THAT(command("protocols.md", "contrast"),
              HasSubstr("contrast --with results/t/real --without results/t-blocked/real --methods "
                        "smote --ratios 10to1 --seeds 0 --output results/t/real/protocols.md"));
}

TEST_F(StepsOfARun, UseThePapersClassifierInAContrast) {
  run_.request.classifiers = "nearest";
  EXPECT_EQ(refusal("contrast"),
            "make contrast: CLASSIFIERS must include wdcnn, the paper's classifier");
}

TEST_F(StepsOfARun, LeaveOutStaleCellsOnBothSidesOfAContrast) {
  run_.request.methods = "none smote";
  run_.request.ratios = "100to1 10to1";
  run_.request.seeds = "0 1";
  run_.run("contrast");
  run_.request.methods = "none";
  EXPECT_THAT(command("protocols.md", "contrast"), Not(HasSubstr("--leave-out")));
  run_.disk.files["results/t-blocked/real/seed1/smote/E.h5"].digest = "other";
  EXPECT_THAT(command("protocols.md", "contrast"),
              HasSubstr(" --leave-out seed1/smote/10to1/wdcnn/diagnosis.h5 --output "));
  EXPECT_THAT(run_.run("contrast"), ElementsAre(testing::Pair("contrast", 1)));
}

TEST_F(StepsOfARun, CompareTheRatesOfBothReadingsOfCwru) {
  for (const std::string name : {"cwru", "cwru-as-published"}) {
    run_.write("datasets/" + name + ".toml",
               "name = \"" + name + "\"\n[[record]]\nfile = \"1.mat\"\nclass = \"a\"\n");
  }
  run_.request.methods = "smote";
  run_.request.datasets = "cwru";
  EXPECT_THAT(logs("contrast"), Not(Contains("t/cwru-as-published/contrast@rates")));
  run_.request.datasets = "cwru cwru-as-published";
  EXPECT_THAT(logs("contrast"), Contains("t/cwru-as-published/contrast@rates"));
  // It needs both data sets, even for a question about this single step.
  EXPECT_EQ(narrowed(run_.request, "results/t/cwru-as-published/contrast@rates").datasets,
            "cwru cwru-as-published");
  EXPECT_EQ(narrowed(run_.request, "results/t/cwru/seed1/split").datasets, "cwru");
  EXPECT_EQ(narrowed(run_.request, "results/t/cwru/seed1/split").seeds, "1");
}

TEST_F(StepsOfARun, RerunOnlyChangedPointsOfASweep) {
  run_.request.ratios = std::nullopt;
  run_.set("epochs = 200",
           "epochs = 200\nbatch = 5\ndepth = 3\n[sweep]\npoints = [\"batch=1\", \"batch=5\", "
           "\"depth=3\", \"depth=4\"]");
  EXPECT_THAT(run_.run("sweep"), Contains(testing::Pair("train", 3)));
  EXPECT_THAT(command("sweep.md", "sweep"), HasSubstr(" --centre batch=5 depth=3 "));
  EXPECT_THAT(run_.run("sweep"), IsEmpty());
  // The method as it is, the new point depth=3, and batch=1, which has the other depth.
  run_.set("depth = 3", "depth = 4");
  EXPECT_THAT(run_.run("sweep"), Contains(testing::Pair("train", 3)));
  EXPECT_THAT(command("sweep.md", "sweep"), HasSubstr(" --centre batch=5 depth=4 "));
  run_.set("batch = 5", "batch = 7");
  EXPECT_THAT(command("sweep.md", "sweep"), HasSubstr(" --centre depth=4 "));
}

TEST_F(StepsOfARun, LeaveOutStaleModelsInAnIdentification) {
  run_.request.datasets = "made";
  run_.set("[generate]", "[train.piae-dt-phase]\nepochs = 2\n[generate]");
  run_.request.methods = "piae-dt piae-dt-phase";
  run_.run("identify");
  run_.request.methods = "piae-dt";
  EXPECT_THAT(run_.run("identify"), IsEmpty());
  run_.set("epochs = 2\n", "epochs = 3\n");
  Plan& plan = run_.plan("identify");
  const auto table = plan.graph().maker_of("results/t/made/identifiability.md");
  ASSERT_TRUE(table);
  EXPECT_THAT(spaced(command_of(plan.graph().at(*table))),
              HasSubstr(" --leave-out seed0/piae-dt-phase --methods piae-dt --seeds 0 "));
}

TEST_F(StepsOfARun, CombineSeveralGoals) {
  run_.request.goals = {"records"};
  Request requested = run_.request;
  requested.goals = {"records", "cells", "results/t/real/seed0/smote/1to1/wdcnn/features.h5"};
  run_.experiment = read_experiment(run_.pipeline.path());
  Plan plan(run_.experiment, choose(run_.experiment, requested), Stretch::grid, run_.disk);
  std::map<std::string, int> counts;
  for (const StepId id : plan.requested()) ++counts[plan.graph().at(id).log];
  EXPECT_EQ(counts["ingest"], 1);
  EXPECT_EQ(counts["features"], 1);
  EXPECT_EQ(counts["tabulate"], 0);
}

}  // namespace
}  // namespace piae::plan
