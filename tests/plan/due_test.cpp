#include "plan/due.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "plan/small_run.hpp"
#include "plan/stage_settings.hpp"

namespace piae::plan {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;
using testing::UnorderedElementsAre;

TEST(DueSteps, AreAllInANewRun) {
  SmallRun run;
  EXPECT_THAT(run.run(),
              UnorderedElementsAre(Pair("ingest", 1), Pair("simulate", 1), Pair("split", 4),
                                   Pair("train", 8), Pair("generate", 8), Pair("score", 8),
                                   Pair("diagnose", 24), Pair("features", 6), Pair("tabulate", 2)));
  EXPECT_THAT(run.run(), IsEmpty());
}

TEST(DueSteps, AreTheMethodsOwnAfterAChangedSetting) {
  SmallRun run;
  run.run();
  run.set("neighbours = 4", "neighbours = 3");
  EXPECT_EQ(run.why("real/seed0/smote/train"), "setting neighbours is 3, was 4");
  EXPECT_EQ(run.why("real/seed0/smote/generate"), "after results/t/real/seed0/smote/train");
  EXPECT_EQ(run.why("real/seed0/piae-dt/train"), "");
  EXPECT_THAT(run.run(),
              UnorderedElementsAre(Pair("train", 4), Pair("generate", 4), Pair("score", 4),
                                   Pair("diagnose", 8), Pair("features", 2), Pair("tabulate", 2)));
}

TEST(DueSteps, IgnoreHowANumberIsWritten) {
  SmallRun run;
  run.run();
  run.set("epochs = 50", "epochs = 50.0  # as many");
  EXPECT_THAT(run.run(), IsEmpty());
}

TEST(DueSteps, IncludeThoseOfARemovedSetting) {
  SmallRun run;
  run.set("epochs = 200", "epochs = 123");
  run.run();
  run.set("epochs = 123\n", "");
  run.set("epochs = 50\n", "");  // the program's default
  EXPECT_EQ(run.why("real/seed0/piae-dt/train"), "setting epochs is 200, was 123");
  EXPECT_EQ(run.why("real/seed0/none/100to1/wdcnn/diagnose"), "");
}

TEST(DueSteps, StopAtAStepWithUnchangedOutput) {
  SmallRun run;
  run.run();
  run.disk.files.erase("results/t/real/seed0/smote/model.h5");
  EXPECT_EQ(run.why("real/seed0/smote/train"), "missing");
  EXPECT_EQ(run.why("real/seed0/smote/10to1/wdcnn/diagnose"),
            "after results/t/real/seed0/smote/generate");
  EXPECT_THAT(run.run(), ElementsAre(Pair("train", 1)));
}

TEST(DueSteps, SpreadFromAStepWithChangedOutput) {
  SmallRun run;
  run.run();
  run.disk.files.erase("results/t/real/seed0/smote/E.h5");
  run.salt = "another machine";
  EXPECT_THAT(run.run(),
              UnorderedElementsAre(Pair("generate", 1), Pair("score", 1), Pair("diagnose", 2),
                                   Pair("features", 1), Pair("tabulate", 1)));
}

TEST(DueSteps, FollowContentsNotTimes) {
  SmallRun run;
  run.run();
  run.disk.files["results/t/real/seed0/smote/E.h5"].digest = "another";
  EXPECT_EQ(run.why("real/seed0/smote/score"), "E.h5 has changed");
  EXPECT_EQ(run.why("real/seed0/smote/generate"), "");
}

TEST(DueSteps, AreThoseThatNeedALostWindowFile) {
  SmallRun run;
  run.run();
  run.disk.files.erase("results/t/real/seed0/B.h5");
  EXPECT_EQ(run.why("real/seed0/split"), "B.h5 is missing");
  EXPECT_THAT(run.run(), ElementsAre(Pair("split", 1)));
}

TEST(DueSteps, RemakeADamagedFile) {
  SmallRun run;
  run.run();
  run.disk.files["results/t/real/seed0/smote/score.h5"] = {
      .digest = {}, .problem = "score.h5: damaged: the digest does not match"};
  EXPECT_EQ(run.why("real/seed0/smote/score"), "score.h5: damaged: the digest does not match");
}

TEST(DueSteps, RemakeAFileThatAnotherReplaced) {
  const std::vector<std::array<std::string, 3>> copies{
      {"real/seed0/D.h5", "real/seed0/C.h5", "real/seed0/split"},
      {"real/seed0/A.h5", "real/seed0/B.h5", "real/seed0/split"},
      {"real/seed0/smote/1to1/wdcnn/diagnosis.h5", "real/seed0/smote/1to1/wdcnn/features.h5",
       "real/seed0/smote/1to1/wdcnn/features"}};
  for (const auto& [from, to, step] : copies) {
    SmallRun run;
    run.run();
    run.disk.files["results/t/" + to] = run.disk.files.at("results/t/" + from);
    EXPECT_EQ(run.why(step), file_name(to) + " holds what belongs in " + file_name(from));
  }
}

TEST(DueSteps, ShowNumbersInShortForm) {
  SmallRun run;
  run.set("epochs = 50\n", "epochs = 50\nlearning-rate = 0.005\n");
  run.run();
  run.set("0.005", "0.1");
  EXPECT_EQ(run.why("real/seed0/smote/10to1/wdcnn/diagnose"),
            "setting learning-rate is 0.1, was 0.005");
}

TEST(DueSteps, AreThoseOfAChangedDescription) {
  SmallRun run;
  run.run();
  run.write("datasets/made.toml", "name = \"made\"\n[simulation]\nnoise = 0.2 # louder\n");
  EXPECT_EQ(run.why("made/simulate"), "made.toml has changed");
  EXPECT_EQ(run.why("real/ingest"), "");
}

TEST(DueSteps, NameTheChangedKeyOfADescription) {
  SmallRun run;
  run.run();
  const std::string file = "results/t/.settings/datasets/made.toml";
  run.disk.texts[file] =
      StageSettings(run.experiment, "results/t").description(*run.experiment.find("made"))->text;
  run.write("datasets/made.toml", "name = \"made\"\n[simulation]\nnoise = 0.2 # louder\n");
  EXPECT_EQ(run.why("made/simulate"), "made.toml: simulation.noise is 0.2, was 0.1");
  run.disk.texts[file] += "another = 1\n";  // not the text that made it
  EXPECT_EQ(run.why("made/simulate"), "made.toml has changed");
}

TEST(DueSteps, CompareAllRecordingsThatAPatternMatches) {
  const Folder folder;
  SmallRun run;
  run.request.data_dir = folder.path().string();
  run.write("datasets/real.toml",
            "name = \"real\"\n[[record]]\nclass = \"a\"\nfile = [\"1.mat\", \"run/*.csv\"]\n");
  const auto record = [&](const std::string& name, const std::string& digest) {
    run.disk.files[folder.write(name, "").string()].digest = digest;
  };
  record("1.mat", "first");
  record("run/2.csv", "second");
  run.run();
  EXPECT_EQ(run.why("real/ingest"), "");
  record("run/2.csv", "another");
  EXPECT_EQ(run.why("real/ingest"), "recording run/2.csv has changed");
  record("run/2.csv", "second");
  record("run/10.csv", "third");
  EXPECT_EQ(run.why("real/ingest"), "it was made without recording run/10.csv");
  run.run();
  std::filesystem::remove(folder / "run/2.csv");
  EXPECT_EQ(run.why("real/ingest"), "recording run/2.csv is gone");
  std::filesystem::remove_all(folder / "run");  // recordings may be deleted
  EXPECT_EQ(run.why("real/ingest"), "");
}

TEST(DueSteps, CompareOnlyExistingRecordings) {
  SmallRun run;
  run.run();
  run.disk.files["data/1.mat"].digest = "another";
  EXPECT_EQ(run.why("real/ingest"), "recording 1.mat has changed");
  run.disk.files.erase("data/1.mat");
  EXPECT_EQ(run.why("real/ingest"), "");
}

TEST(DueSteps, IgnoreRecordingsWithoutStoredDigests) {
  SmallRun run;
  run.run();
  artefact::Made& made = *run.disk.files["results/t/real/records.h5"].made;
  std::erase_if(made.inputs, [](const auto& from) { return from.role != "description"; });
  EXPECT_EQ(run.why("real/ingest"), "");
}

TEST(DueTables, CompareTheCellsThatTheyWereMadeOf) {
  SmallRun run;
  run.run();
  run.disk.files.erase("results/t/real/accuracy.csv");
  EXPECT_EQ(run.why("real/tabulate"), "accuracy.csv is missing");
  EXPECT_THAT(run.run(), ElementsAre(Pair("tabulate", 1)));
  run.disk.files["results/t/real/tables.md"].digest = "edited by hand";
  EXPECT_EQ(run.why("real/tabulate"), "tables.md differs from what the journal records");
  run.run();
  run.disk.files["results/t/real/seed1/none/100to1/wdcnn/diagnosis.h5"].digest = "another";
  EXPECT_EQ(run.why("real/tabulate"), "cells have changed");
  run.disk.steps.erase("results/t/real/tabulate");
  EXPECT_EQ(run.why("real/tabulate"), "the journal does not record how it was made");
}

TEST(DueTables, ReportANewNumberOfCells) {
  SmallRun run;
  run.run();
  run.request.seeds = "0";
  run.disk.files.erase("results/t/real/seed1/none/100to1/wdcnn/diagnosis.h5");
  EXPECT_THAT(run.why("real/tabulate"), HasSubstr("number of cells is "));
}

TEST(DueTables, CoverTheWholeRunIfAPartIsRequested) {
  SmallRun run;
  run.run();
  run.request.seeds = "0";
  run.request.methods = "none smote";
  EXPECT_THAT(run.run(), IsEmpty());
}

TEST(DueTables, LeaveOutStaleCellsThatAreNotRequested) {
  SmallRun run;
  run.run();
  run.set("neighbours = 4", "neighbours = 3");
  run.request.methods = "none piae-dt";
  EXPECT_THAT(run.run(), ElementsAre(Pair("tabulate", 2)));
  EXPECT_THAT(run.run(), IsEmpty());
  Plan& plan = run.plan();
  const auto words =
      command_of(plan.graph().at(*plan.graph().maker_of("results/t/real/tables.md")));
  const auto option = std::ranges::find(words, "--leave-out");
  ASSERT_NE(option, words.end());
  EXPECT_THAT(std::vector<std::string>(option + 1, option + 3),
              ElementsAre("seed0/smote", "seed1/smote"));
}

TEST(DueTables, UseCellsWhoseInputsWereDeleted) {
  SmallRun run;
  run.run();
  run.disk.files.erase("results/t/real/seed0/smote/E.h5");
  run.disk.files.erase("results/t/real/seed0/smote/model.h5");
  run.request.methods = "none piae-dt";
  EXPECT_THAT(run.run(), IsEmpty());
}

TEST(ArtefactsOfAPlan, AreReadTogether) {
  for (const std::string goal : {"all", "cells", "tables", "sweep", "contrast", "identify",
                                 "readings", "trust", "verdicts"}) {
    for (const Stretch stretch : {Stretch::grid, Stretch::numbers, Stretch::pages}) {
      SmallRun run;
      run.request.ratios = std::nullopt;
      run.set("epochs = 200",
              "epochs = 200\nbatch = 5\n[sweep]\npoints = [\"batch=1\"]\n[readings]\n"
              "base = [\"batch=5\"]\nreadings = [\"depth=4\"]");
      run.run();
      run.run(goal);
      run.disk.expected.clear();
      run.disk.read_alone.clear();
      run.request.methods = "none piae-dt";  // smote's cells are held only
      (void)run.plan(goal, stretch).to_run();
      EXPECT_THAT(run.disk.read_alone, IsEmpty()) << goal;
    }
  }
}

TEST(DueNumbersOfFigures, AreThoseWithALostTable) {
  SmallRun run;
  run.run();
  const auto figures_step = [&](const Plan& plan) {
    const std::vector<StepId> ids = plan.requested();
    return *std::ranges::find_if(
        ids, [&](StepId id) { return name_of(plan.graph().at(id)) == "results/t/real/figures"; });
  };
  Plan& first = run.plan("all", Stretch::numbers);
  const StepId id = figures_step(first);
  EXPECT_EQ(first.judge().of(id).why, "the journal does not record how it was made");
  const std::string table = "results/t/real/figures/gains.csv";
  run.disk.files[table] = {.digest = "1"};
  run.disk.steps["results/t/real/figures"] = first.judge().made_now(id);
  Plan& second = run.plan("all", Stretch::numbers);
  EXPECT_EQ(second.judge().of(figures_step(second)).state, State::current);
  run.disk.files.erase(table);
  Plan& third = run.plan("all", Stretch::numbers);
  EXPECT_EQ(third.judge().of(figures_step(third)).why, "gains.csv is missing");
  // A narrower look may have removed pictures, so a wider one rewrites the numbers.
  run.disk.files[table] = {.digest = "1"};
  Plan& looking = run.plan("figures", Stretch::numbers);
  EXPECT_EQ(looking.judge().of(figures_step(looking)).why,
            "setting methods is none smote piae-dt, was not set");
  run.disk.steps["results/t/real/figures"] = looking.judge().made_now(figures_step(looking));
  Plan& whole = run.plan("all", Stretch::numbers);
  EXPECT_THAT(whole.judge().of(figures_step(whole)).why, testing::HasSubstr(" is not set, was "));
}

TEST(DueNumbersOfFigures, DoNotWaitForCellsThatAreLeftOut) {
  SmallRun run;
  run.run();
  std::string& windows = run.disk.files["results/t/real/seed0/smote/E.h5"].digest;
  const std::string before = std::exchange(windows, "another");
  run.request.methods = "none piae-dt";  // so that smote's files are held only
  Plan& first = run.plan("all", Stretch::numbers);
  const StepId id = first.requested().front();
  EXPECT_EQ(first.judge().of(id).state, State::due);
  run.disk.files["results/t/real/figures/gains.csv"] = {.digest = "1"};
  run.disk.steps[name_of(first.graph().at(id))] = first.judge().made_now(id);
  Plan& second = run.plan("all", Stretch::numbers);
  EXPECT_EQ(second.judge().of(second.requested().front()).why, "");
  windows = before;
  Plan& third = run.plan("all", Stretch::numbers);
  EXPECT_EQ(third.judge().of(third.requested().front()).why,
            "other cells are left out, because they are stale");
}

TEST(DueNumbersOfFigures, ShowAllCellsIfAllIsRequested) {
  SmallRun run;
  run.run();
  Plan& all = run.plan("all", Stretch::numbers);
  const StepId id = all.requested().front();
  const std::string name = name_of(all.graph().at(id));
  run.disk.steps[name] = all.judge().made_now(id);
  Plan& both = run.plan("all figures", Stretch::numbers);
  EXPECT_EQ(both.judge().of(both.requested().front()).why, "");
}

TEST(Pages, AreNotDueIfTheyExist) {
  SmallRun run;
  run.run();
  for (const char* page : {"report.html", "report.md", "run.html"}) {
    run.disk.files[std::string("results/t/") + page] = {.digest = "1"};
  }
  EXPECT_EQ(run.plan("all", Stretch::pages).to_run().size(), 1U);
  run.current->keep_pages();
  EXPECT_THAT(run.current->to_run(), IsEmpty());
  run.disk.files.erase("results/t/run.html");
  Plan& lacks = run.plan("all", Stretch::pages);
  lacks.keep_pages();
  ASSERT_EQ(lacks.to_run().size(), 1U);
  EXPECT_EQ(lacks.judge().of(lacks.to_run().front()).why, "run.html is missing");
}

TEST(Values, AreTheSameAsNumbers) {
  EXPECT_TRUE(same_value("5e-4", "0.0005"));
  EXPECT_TRUE(same_value("0.00050000000000000001", "5e-4"));
  EXPECT_FALSE(same_value("5", "6"));
  EXPECT_FALSE(same_value("class", "all"));
  EXPECT_FALSE(same_value("", "0"));
}

}  // namespace
}  // namespace piae::plan
