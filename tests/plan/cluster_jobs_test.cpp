#include "plan/cluster_jobs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plan/logs_of_values.hpp"
#include "plan/small_run.hpp"
#include "support/errors.hpp"

namespace piae::plan {
namespace {

using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

/// One method costs 600 s a seed, another 60 s; everything else is free.
Costs costs() {
  Costs costs;
  costs.learn("train", {.dataset = "real", .method = "piae-dt"},
              {.seconds = 600, .megabytes = 200});
  costs.learn("train", {.dataset = "real", .method = "smote"}, {.seconds = 60, .megabytes = 100});
  for (const char* stage : {"ingest", "simulate", "split", "generate", "score", "diagnose by wdcnn",
                            "diagnose by nearest", "tabulate"}) {
    costs.learn(stage, {}, {.seconds = 0, .megabytes = 10});
  }
  return costs;
}

TEST(JobsOfACluster, TakeAboutTheSameTimeEach) {
  SmallRun run;
  run.request.datasets = "real";
  const auto kinds = divide(run.plan("tables"), costs(), 1, 10);
  ASSERT_THAT(kinds, SizeIs(3));
  EXPECT_EQ(kinds[0].name, "records");
  EXPECT_THAT(kinds[0].files, SizeIs(1));
  EXPECT_THAT(kinds[0].files.front(),
              testing::ElementsAre("results/t/real/records.h5", "results/t/real/seed0/A.h5",
                                   "results/t/real/seed1/A.h5"));
  EXPECT_EQ(kinds[1].name, "cells");
  EXPECT_THAT(kinds[1].files, SizeIs(3));  // 1320 s in jobs of 600 s
  EXPECT_EQ(kinds[1].seconds, 1320);
  // Twice the longest plus five minutes, rounded up to five minutes: 600 s give 25 minutes.
  EXPECT_EQ(kinds[1].minutes, 25);
  EXPECT_EQ(kinds[1].megabytes, 500);
  EXPECT_EQ(kinds[2].name, "tables");
  EXPECT_EQ(kinds[2].steps, 1U);
}

TEST(JobsOfACluster, MakeEachFileOnce) {
  SmallRun run;
  const auto kinds = divide(run.plan("cells"), costs(), 4, 15);
  std::vector<std::string> files;
  for (const JobKind& kind : kinds) {
    for (const auto& job : kind.files) files.insert(files.end(), job.begin(), job.end());
  }
  std::ranges::sort(files);
  EXPECT_EQ(std::ranges::adjacent_find(files), files.end());
  EXPECT_THAT(files, SizeIs(run.plan("cells").to_run().size()));
}

TEST(JobsOfACluster, NumberAtMostFiveHundred) {
  SmallRun run;
  run.request.datasets = "real";
  run.request.methods = "piae-dt";
  for (int seed = 2; seed <= 600; ++seed) *run.request.seeds += ' ' + std::to_string(seed);
  const auto kinds = divide(run.plan("cells"), costs(), 1, 1);
  EXPECT_EQ(kinds[1].name, "cells");
  EXPECT_THAT(kinds[1].files, SizeIs(500));
  EXPECT_EQ(kinds[1].seconds, 601 * 600);
  EXPECT_EQ(kinds[1].minutes, 45);  // two seeds, 1200 s
}

TEST(JobsOfACluster, StartWithTheLongest) {
  SmallRun run;
  run.request.datasets = "real";
  const auto kinds = divide(run.plan("cells"), costs(), 1, 10);
  ASSERT_THAT(kinds[1].files, SizeIs(3));
  EXPECT_THAT(kinds[1].files[0], Each(HasSubstr("/seed0/piae-dt/")));
  EXPECT_THAT(kinds[1].files[1], Each(HasSubstr("/seed1/piae-dt/")));
  EXPECT_THAT(kinds[1].files[2], Each(Not(HasSubstr("/piae-dt/"))));
}

TEST(JobsOfACluster, ListTheFilesOfAMethodInOrder) {
  SmallRun run;
  run.narrow_to("smote", "1to1");
  run.request.classifiers = "nearest wdcnn-spectra";
  const auto kinds = divide(run.plan("tables"), costs(), 4, 1);
  ASSERT_THAT(kinds[1].files, SizeIs(1));
  const std::string folder = "results/t/real/seed0/smote/";
  const auto& files = kinds[1].files.front();
  const auto place = [&](const std::string& file) {
    const auto found = std::ranges::find(files, folder + file);
    EXPECT_NE(found, files.end()) << file;
    return found - files.begin();
  };
  EXPECT_LT(place("model.h5"), place("E.h5"));
  for (const char* file :
       {"score.h5", "1to1/nearest/diagnosis.h5", "1to1/wdcnn-spectra/diagnosis.h5"}) {
    EXPECT_LT(place("E.h5"), place(file));
  }
}

TEST(JobsOfACluster, RequestTheMemoryOfTheirLargestSteps) {
  SmallRun run;
  Costs with_large_records = costs();
  with_large_records.learn("ingest", {.dataset = "real"}, {.seconds = 0, .megabytes = 900});
  const auto kinds = divide(run.plan("cells"), with_large_records, 2, 10);
  EXPECT_EQ(kinds[0].megabytes, 2100);  // two at a time, and 300 MB
  EXPECT_EQ(kinds[1].megabytes, 700);
}

TEST(JobsOfACluster, EstimateAMovedSettingByItsMethod) {
  SmallRun run;
  run.narrow_to("piae-dt", "1to1");
  run.set("epochs = 200", "epochs = 200\n[sweep]\npoints = [\"batch=1\"]");
  const auto kinds = divide(run.plan("sweep"), costs(), 1, 10);
  EXPECT_EQ(kinds[1].seconds, 1200);
  ASSERT_THAT(kinds[1].files, SizeIs(2));  // the method as it is, and the point
  EXPECT_THAT(kinds[1].files[1], Each(HasSubstr("/seed0/sweep/batch-1/")));
}

TEST(JobsOfACluster, SeparateMethodsThatNeedAGpu) {
  SmallRun run;
  run.set("epochs = 200", "epochs = 200\ndevice = \"cuda\"");
  const auto kinds = divide(run.plan("cells"), costs(), 4, 15);
  ASSERT_THAT(kinds, SizeIs(4));
  EXPECT_EQ(kinds[1].name, "cells");
  for (const auto& job : kinds[1].files) EXPECT_THAT(job, Each(Not(HasSubstr("/piae-dt/"))));
  EXPECT_EQ(kinds[2].name, "cells-gpu");
  for (const auto& job : kinds[2].files) EXPECT_THAT(job, Each(HasSubstr("/piae-dt/")));
  // Steps that read the model go with it.
  EXPECT_THAT(kinds[2].files.front(), Contains(HasSubstr("/diagnosis.h5")));
}

TEST(JobsOfACluster, AreWrittenAsLists) {
  const std::vector<JobKind> kinds{
      {.name = "cells", .cores = 2, .minutes = 10, .megabytes = 300, .files = {{"a"}, {"b", "c"}}},
      {.name = "tables", .minutes = 20, .megabytes = 800, .files = {{}}}};
  const Folder folder;
  write_jobs(kinds, folder.path());
  EXPECT_EQ(bytes_of(folder / "jobs"), "cells\t2\t2\t10\t300\ntables\t1\t1\t20\t800\n");
  EXPECT_EQ(bytes_of(folder / "cells.1"), "b\nc\n");
  EXPECT_THAT(table_of(kinds), HasSubstr("cells           2      2     0:10 h     0.3 GB"));
}

TEST(CostsOfSteps, AreTakenFromTheMostSimilarSteps) {
  const Folder folder;
  const auto file = folder.write(
      "costs.csv",
      "# of a machine\nstage,dataset,method,classifier,ratio,seconds,megabytes\n"
      "train,cwru,vae,,,10,100\ntrain,cwru,smote,,,2,50\ndiagnose,cwru,none,wdcnn,100to1,3,80\n");
  const Costs costs = Costs::read(file);
  const auto seconds = [&](const Step& step) { return costs.of(step).cost.seconds; };
  EXPECT_EQ(seconds({.stage = "train", .place = {.dataset = "hit-sm", .method = "smote"}}), 2);
  const Step unknown{.stage = "train", .place = {.dataset = "cwru", .method = "magic"}};
  EXPECT_EQ(seconds(unknown), 10);
  EXPECT_TRUE(costs.of(unknown).is_guess);
  EXPECT_EQ(
      seconds({.stage = "diagnose",
               .place = {.dataset = "x", .method = "y", .ratio = "1to1", .classifier = "wdcnn"}}),
      3);
}

TEST(CostsOfSteps, AreMeanSecondsAndMaximumMemoryOfTheLogs) {
  SmallRun run;
  run.request.datasets = "real";
  run.request.methods = "none smote";
  LogsOfValues logs;
  const auto used = [&](const std::string& step, run::StepEnd end, double seconds, double memory) {
    logs.logs["results/t/real/" + step + ".log"] = {
        .end = end, .processor_s = seconds, .memory_mb = memory};
  };
  used("seed0/smote/train", run::StepEnd::done, 2, 10);
  used("seed1/smote/train", run::StepEnd::done, 5, 150);
  used("seed1/smote/1to1/wdcnn/diagnose", run::StepEnd::interrupted, 9, 9);
  used("seed1/none/100to1/nearest/diagnose", run::StepEnd::done, 1, 20);
  used("seed1/none/100to1/wdcnn/diagnose", run::StepEnd::done, 7, 20);
  used("seed0/none/100to1/wdcnn/features", run::StepEnd::done, 100, 100);
  EXPECT_EQ(measured_costs(run.plan("all"), logs),
            "stage,dataset,method,classifier,ratio,seconds,megabytes\n"
            "diagnose,real,none,nearest,100to1,1.00,20\n"
            "diagnose,real,none,wdcnn,100to1,7.00,20\ntrain,real,smote,,,3.50,150\n");
}

}  // namespace
}  // namespace piae::plan
