#include "plan/printed.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plan/small_run.hpp"

namespace piae::plan {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Makefiles, HaveARuleForEachDueStep) {
  SmallRun run;
  run.narrow_to("smote", "10to1");
  const std::string text = makefile_of(run.plan("tables"), true);
  EXPECT_THAT(text, HasSubstr("\nresults/t/real/seed0/smote/model.h5: results/t/real/seed0/A.h5\n"
                              "\t@pipeline/step.sh results/t/real/seed0/smote train --config "
                              "results/t/.settings/train.smote.toml --known "
                              "results/t/real/seed0/C.h5 --method smote --seed 0 --output "
                              "results/t/real/seed0/smote/model.h5\n"));
  EXPECT_THAT(text, HasSubstr("\t@pipeline/step.sh results/t/real/seed0 split --config "
                              "results/t/.settings/split.toml --records results/t/real/records.h5 "
                              "--seed 0 --protocol random --output-dir results/t/real/seed0 -- "
                              "results/t/real/seed0/A.h5 results/t/real/seed0/B.h5 "
                              "results/t/real/seed0/C.h5 results/t/real/seed0/D.h5\n"));
  EXPECT_THAT(text, HasSubstr("\t@$(BIN)/plan --note results/t/real/tabulate\n"));
  EXPECT_THAT(text, HasSubstr(".PHONY: steps results/t/real/records.h5 "));
}

TEST(Makefiles, AreEmptyIfNoStepIsDue) {
  SmallRun run;
  run.run();
  EXPECT_EQ(makefile_of(run.plan(), true), "");
}

TEST(Makefiles, RecheckStepsThatWaitForOthers) {
  SmallRun run;
  run.run();
  run.disk.files.erase("results/t/real/seed0/smote/model.h5");
  const std::string text = makefile_of(run.plan(), false);
  EXPECT_THAT(text, HasSubstr("\n\tpipeline/step.sh results/t/real/seed0/smote train "));
  EXPECT_THAT(text,
              HasSubstr("\n\tONLY_IF_DUE=yes pipeline/step.sh results/t/real/seed0/smote score "));
  EXPECT_THAT(text, Not(HasSubstr("seed0/piae-dt")));
}

/// One picture of all groups joins their tables.
TEST(Makefiles, DrawEachTableAndTheJoinedGroups) {
  SmallRun run;
  const std::string group =
      "]\ndatasets = [\"real\", \"made\"]\nagainst = \"smote\"\ninputs = [\"smote=wdcnn\"]\n";
  run.set("[split]", "[transfer.a" + group + "[transfer.b" + group + "[split]");
  run.request.methods = "smote";
  run.request.datasets = "real made";
  const std::string text = makefile_of(run.plan("transfer"), true);
  EXPECT_THAT(text, HasSubstr("pipeline/figures/draw.sh results/t/transfer@a.csv\n"));
  EXPECT_THAT(text,
              HasSubstr("pipeline/figures/draw.sh results/t/rigs.csv results/t/transfer@a.csv "
                        "results/t/transfer@b.csv\n"));
}

TEST(Makefiles, QuoteAFolderWithBlanks) {
  SmallRun run;
  run.request.data_dir = "my data";
  EXPECT_THAT(makefile_of(run.plan("records"), true), HasSubstr(" --data-dir 'my data' "));
}

TEST(Reasons, ListFewStepsOneByOne) {
  SmallRun run;
  run.run();
  run.disk.files.erase("results/t/real/seed0/smote/model.h5");
  EXPECT_EQ(
      why_of(run.plan()),
      "real/seed0/smote train: missing\n"
      "then, if the steps above change their inputs: 2 diagnose, 1 features, 1 generate, 1 score, "
      "1 tabulate\n");
}

TEST(Reasons, CombineManySteps) {
  SmallRun run;
  run.run();
  run.set("epochs = 50", "epochs = 60");
  EXPECT_THAT(
      why_of(run.plan("cells")),
      HasSubstr("real/seed0/none/100to1/wdcnn diagnose and 11 more: setting epochs is 60, was "
                "50\n"));
  run.run();
  EXPECT_EQ(why_of(run.plan()), "");
}

}  // namespace
}  // namespace piae::plan
