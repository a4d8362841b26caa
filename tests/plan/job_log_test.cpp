#include "plan/job_log.hpp"

#include <gtest/gtest.h>

namespace piae::plan {
namespace {

using Lines = std::vector<std::string>;

std::string why_of(Lines lines) {
  lines.insert(lines.begin(), "job: life started at 100 on node7, 4 cores");
  return read_job_log("cells.3", lines).why;
}

TEST(JobLog, SaysWhyAJobEnded) {
  const std::string in_time = "job: life ended at 200, used 390.1 s, status 0: done";
  const std::string of_time =
      "slurmstepd: error: *** JOB 5 ON n1 CANCELLED AT 2026-01-01T00:00:00 DUE TO TIME LIMIT ***";
  const std::string of_memory = "slurmstepd: error: Detected 1 oom_kill event in StepId=5.0.";
  EXPECT_EQ(why_of({}), "killed");
  EXPECT_EQ(why_of({in_time}), "");
  EXPECT_EQ(why_of({"job: life ended at 2, used 1 s, status 1: some \x1b[2Jsteps failed"}),
            "some ?[2Jsteps failed");
  EXPECT_EQ(why_of({of_time}), "out of time");
  EXPECT_EQ(why_of({"error: *** JOB 5 ON n1 CANCELLED AT 2026-01-01T00:00:00 ***"}), "cancelled");
  EXPECT_EQ(why_of({"error: *** JOB 5 ON n1 CANCELLED AT x DUE TO NODE FAILURE ***"}),
            "its node failed");
  EXPECT_EQ(why_of({of_memory}), "out of memory");
  EXPECT_EQ(why_of({"slurmstepd: Exceeded job memory limit"}), "out of memory");
  EXPECT_EQ(why_of({of_memory, of_time}), "out of memory");
  // The next life starts from scratch.
  EXPECT_EQ(why_of({of_time, "job: life started at 300 on n1, 4 cores", in_time}), "");
}

TEST(JobLog, ListsTheLivesOfAJob) {
  const JobLog log = read_job_log(
      "cells.3", {"job: life started at 100 on node7, 4 cores", "anything",
                  "job: life ended at 160, used 12.5 s, status 75: out of time, goes back",
                  "job: life started at 200 on node 8, rack 2, 3 cores", "job: life started at x"});
  ASSERT_EQ(log.lives.size(), 2U);
  EXPECT_EQ(log.lives[0].start_s, 100);
  EXPECT_EQ(log.lives[0].end_s, 160);
  EXPECT_EQ(log.lives[0].used_s, 12.5);
  EXPECT_EQ(log.lives[0].cores, 4);
  EXPECT_EQ(log.lives[1].cores, 3);
  EXPECT_EQ(log.lives[1].end_s, std::nullopt);
}

/// A job that was queued before an update writes the old word.
TEST(JobLog, ReadsLivesThatWereBegun) {
  const JobLog log = read_job_log("cells.3", {"job: life begun at 100 on node7, 4 cores"});
  ASSERT_EQ(log.lives.size(), 1U);
  EXPECT_EQ(log.lives[0].start_s, 100);
  EXPECT_EQ(log.lives[0].cores, 4);
}

TEST(JobLog, SumsWhatJobsSpent) {
  // 3600 s on 2 cores, 1.5 core-hours used; 900 s on 4 cores; the tables for 60 s on one core.
  const std::vector<JobLog> jobs{
      {"cells.0", {{1100, 2, 4700, 5400}}, ""},
      {"cells.1", {{1400, 4, std::nullopt, 0}, {3800, 4, 4700, 0}}, ""},
      {"tables", {{4900, 1, std::nullopt, 0}}, "killed"},
  };
  // Idle: 100 s before the first job starts, 200 s before the tables start.
  EXPECT_EQ(spent_by(jobs, 1000, 4960, 7),
            "spent: 7 steps in 3 jobs; 1.50 core-hours used of 3.02 allocated (50 %); 66 min from "
            "submission to end, of which 5 min in the queue alone\n"
            "spent: 1 jobs began again (out of time, or a node was lost)\n"
            "spent: 1 lives were killed, whose time is not counted\n");
  EXPECT_EQ(spent_by({}, 1000, 1119, 0),
            "spent: 0 steps in 0 jobs; 0.00 core-hours used of 0.00 allocated (0 %); 119 s from "
            "submission to end, of which 0 s in the queue alone\n");
}

}  // namespace
}  // namespace piae::plan
