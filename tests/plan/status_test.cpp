#include "plan/status.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plan/logs_of_values.hpp"
#include "plan/small_run.hpp"
#include "plan/submission.hpp"
#include "support/errors.hpp"

namespace piae::plan {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A run of one data set, two methods and two seeds.
class StatusOfARun : public testing::Test {
 protected:
  StatusOfARun() {
    run_.request.datasets = "real";
    run_.request.methods = "none smote";
  }

  /// Returns the table, with one blank between words, and the list below it.
  std::string status(const std::string& goals = "cells") {
    Plan& plan = run_.plan(goals);
    const auto states = step_states(plan, logs_, jobs_);
    std::string text = status_table(plan, states, logs_) + listed_steps(plan, states);
    std::string narrow;
    for (const char c : text) {
      if (c != ' ' || (!narrow.empty() && narrow.back() != ' ')) narrow += c;
    }
    return narrow;
  }

  SmallRun run_;
  LogsOfValues logs_;
  EndedJobs jobs_;
};

TEST_F(StatusOfARun, CountsCellsThatAreMissing) {
  EXPECT_EQ(status(),
            "data set method cells done running failed missing time left\n"
            "real records, split 0 0 0 0 0 not known yet\n"
            "real none 4 0 0 0 4 not known yet\n"
            "real smote 6 0 0 0 6 not known yet\n"
            "all 10 0 0 0 10 not known yet\n");
}

TEST_F(StatusOfARun, CountsCellsThatAreDone) {
  run_.run("cells");
  EXPECT_EQ(status(),
            "data set method cells done running failed missing time left\n"
            "real none 4 4 0 0 0 0 s\nreal smote 6 6 0 0 0 0 s\nall 10 10 0 0 0 0 s\n");
}

TEST_F(StatusOfARun, EstimatesTimeFromSimilarSteps) {
  run_.run("cells");
  for (const char* seed : {"seed0", "seed1"}) {
    const std::string of_seed = std::string("real/") + seed;
    logs_.took(of_seed + "/smote/train", 40);
    logs_.took(of_seed + "/smote/1to1/wdcnn/diagnose", 100);
    logs_.took(of_seed + "/smote/10to1/wdcnn/diagnose", 20);
  }
  run_.disk.files.erase("results/t/real/seed1/smote/1to1/wdcnn/diagnosis.h5");
  EXPECT_THAT(status(), HasSubstr("real smote 6 5 0 0 1 2 min\n"));
  run_.disk.files.erase("results/t/real/seed1/none/100to1/nearest/diagnosis.h5");
  EXPECT_THAT(status(), HasSubstr("real none 4 3 0 0 1 47 s\n"));  // 140 s in three diagnoses
  EXPECT_THAT(status(), HasSubstr("all 10 8 0 0 2 2 min\n"));
}

TEST_F(StatusOfARun, CountsAllCellsThatAFailedStepBlocks) {
  run_.run("cells");
  for (const char* file : {"model.h5", "E.h5", "score.h5", "1to1/wdcnn/diagnosis.h5"}) {
    run_.disk.files.erase(std::string("results/t/real/seed1/smote/") + file);
  }
  logs_.logs["results/t/real/seed1/smote/train.log"] = {
      .stage = "train", .end = run::StepEnd::failed, .reason = "the reason", .exit_code = 65};
  const std::string text = status();
  EXPECT_THAT(text, HasSubstr("real smote 6 3 0 3 0 "));
  EXPECT_THAT(text, HasSubstr("\nfailed\n real/seed1/smote: train: the reason (log: "
                              "results/t/real/seed1/smote/train.log)\n"));
}

TEST_F(StatusOfARun, ShowsRunningStepsAndTheirProgress) {
  run_.run("cells");
  run_.disk.files.erase("results/t/real/seed0/smote/score.h5");
  const std::string log = "results/t/real/seed0/smote/score.log";
  logs_.logs[log] = {
      .stage = "score", .end = run::StepEnd::open, .last_progress = "score ##.. 50 %"};
  EXPECT_THAT(status(), HasSubstr("real smote 6 5 0 0 1 "));  // it was killed
  logs_.locked = log;
  EXPECT_THAT(status(), HasSubstr("real smote 6 5 1 0 0 "));
  EXPECT_THAT(status(), HasSubstr("\nrunning\n real/seed0/smote: score ##.. 50 % (log: " + log));
  EXPECT_THAT(status(), Not(HasSubstr("failed\n ")));
}

TEST_F(StatusOfARun, ShowsWhyAJobEndedIfItsStepDoesNot) {
  run_.run("cells");
  run_.disk.files.erase("results/t/real/seed0/smote/score.h5");
  run::StepLog& log = logs_.logs["results/t/real/seed0/smote/score.log"];
  log = {.stage = "score", .end = run::StepEnd::open};
  jobs_.by_file["results/t/real/seed0/smote/score.h5"] = "out of memory";
  EXPECT_THAT(status(), HasSubstr("score: its job ended: out of memory (log: "));
  log = {.stage = "score",
         .end = run::StepEnd::failed,
         .reason = "killed, perhaps for want of memory",
         .exit_code = 137};
  EXPECT_THAT(status(), HasSubstr("score: its job ended: out of memory (log: "));
  log.reason = "its own reason";
  EXPECT_THAT(status(), HasSubstr("score: its own reason (log: "));
  jobs_.by_file.clear();
  log.reason.clear();
  log.exit_code = 139;
  EXPECT_THAT(status(), HasSubstr("score: exit code 139 (log: "));
}

TEST_F(StatusOfARun, CountsModelsOfAnIdentification) {
  run_.request.datasets = "made";
  run_.request.methods = "piae-dt";
  const std::string text = status("identify");
  EXPECT_THAT(text, HasSubstr("data set method models done "));
  EXPECT_THAT(text, HasSubstr("made piae-dt 2 0 0 0 2 "));
}

TEST_F(StatusOfARun, CountsClassifiersOfTrust) {
  run_.request.ratios = "10to1";
  EXPECT_THAT(status("trust"), HasSubstr("real smote 2 0 0 0 2 "));
}

TEST(Submissions, SupplyTheGoalAndListsIfNoneIsGiven) {
  const Folder folder;
  folder.write("choice", "sweep\nRUN=t\nSEEDS=0 1\nMETHODS=piae-dt\n");
  folder.write("cells.0", "results/t/a.h5\nresults/t/b.h5\n");
  folder.write("cells.0.log", "job: life ended at 1, used 1 s, status 1: out of time\x1b[2J\n");
  folder.write("cells.1.log", "job: life started at 1 on n1, 4 cores\n");
  folder.write("tables.log", "job: life started at 1 on n1, 4 cores\nspent: 3 steps\n");
  std::istringstream lines(
      "submission\t" + folder.path().string() +
      "\nqueue\tcells.1\tPENDING\tResources\nqueue\tcells.2\tPENDING\tResources\n"
      "queue\ttables\tRUNNING\tNone\n");
  const Submission submission = read_submission(lines);
  Request request;
  request.seeds = "7";
  take_submission(submission, request, false);
  EXPECT_EQ(request.goals, std::vector<std::string>{"sweep"});
  EXPECT_EQ(request.methods, "piae-dt");
  EXPECT_EQ(request.seeds, "7");
  EXPECT_EQ(ended_jobs(submission).by_file.at("results/t/b.h5"), "out of time?[2J");
  EXPECT_EQ(listed_jobs(submission),
            "\njobs\n  cells: 2 pending (Resources)\n  tables: 1 running\n  cells.0: out of "
            "time?[2J (log: " +
                folder.path().string() + "/cells.0.log)\nspent: 3 steps\n");
  Request other;
  other.goals = {"cells"};
  take_submission(submission, other, true);
  EXPECT_EQ(other.methods, std::nullopt);
}

TEST(Submissions, ReportKilledJobsOnlyIfTheQueueIsKnown) {
  const Folder folder;
  folder.write("choice", "all\n");
  folder.write("cells.0.log", "job: life started at 1 on n1, 4 cores\n");
  folder.write("cells.1.log", "job: life started at 1 on n1, 4 cores\nDUE TO TIME LIMIT\n");
  const std::string named = "submission\t" + folder.path().string() + '\n';
  const auto ended = [&](const std::string& queue) {
    std::istringstream lines(named + queue);
    std::string jobs;
    for (const auto& job : read_submission(lines).ended) jobs += job.job + ": " + job.why + "; ";
    return jobs;
  };
  EXPECT_EQ(ended(""), "cells.0: killed; cells.1: out of time; ");
  EXPECT_EQ(ended("queue\tcells.0\tRUNNING\tNone\n"), "cells.1: out of time; ");
  EXPECT_EQ(ended("queue\t?\t?\tno answer\n"), "cells.1: out of time; ");
}

TEST(Submissions, RefuseAnEmptyChoiceUnlessAGoalIsGiven) {
  const Folder folder;
  folder.write("choice", "");
  std::istringstream lines("submission\t" + folder.path().string() + '\n');
  const Submission submission = read_submission(lines);
  Request request;
  request.goals = {"cells"};
  take_submission(submission, request, true);
  EXPECT_EQ(request.goals, std::vector<std::string>{"cells"});
  EXPECT_ERROR(take_submission(submission, request, false), Exit::bad_input,
               (folder / "choice").string() + ": is missing or empty; remove the folder, or name");
}

TEST(Submissions, ReportWhatTheySpent) {
  const Folder folder;
  const fs::path submission = folder.path() / "results/t/.jobs/1";
  fs::create_directories(submission);
  fs::create_directories(folder.path() / "results/t-blocked");
  const std::string done = "train\nstep: started at 99999999999.0\nstep: exit 0 after 1.0 s\n";
  folder.write("results/t/.jobs/1/choice", "contrast\n");
  folder.write("results/t/old.log", "train\nstep: started at 1.0\nstep: exit 0 after 1.0 s\n");
  folder.write("results/t/new.log", done);
  folder.write("results/t/failed.log",
               "train\nstep: started at 99999999999.0\nstep: exit 65 after 1.0 s\n");
  folder.write("results/t-blocked/new.log", done);
  // A submission of tables alone has no lists.
  EXPECT_THAT(spent_by_submission(submission), StartsWith("spent: 1 steps in 0 jobs; "));
  folder.write("results/t/.jobs/1/cells.0", "results/t/a/b.h5\nresults/t-blocked/a/b.h5\n");
  folder.write("results/t/.jobs/1/cells.1", "results/never-made/a/b.h5\n");
  EXPECT_THAT(spent_by_submission(submission), StartsWith("spent: 2 steps in 0 jobs; "));
  EXPECT_THAT(spent_by_submission(submission / ""), StartsWith("spent: 2 steps in 0 jobs; "));
  EXPECT_THROW(spent_by_submission(folder.path()), Error);
}

}  // namespace
}  // namespace piae::plan
