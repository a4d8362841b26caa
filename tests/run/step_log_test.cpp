#include "run/step_log.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/folder.hpp"

namespace piae::run {
namespace {

using testing::DoubleNear;

std::string log_text(double started, const std::string& lines) {
  return "build/bin/train --seed 0\nstep: started at " + std::to_string(started) + "\n" + lines;
}

TEST(StepLogs, GiveTheCostOfTheStep) {
  const Folder folder;
  const auto log = read_step_log(folder.write(
      "train.log", log_text(1763800000.25,
                            "trained vae on 45 windows: results/t/model.h5\nstep: used 11.93 s of "
                            "processor time and 153 MB of memory\nstep: exit 0 after 12.3 s\n")));
  EXPECT_EQ(log.stage, "train");
  EXPECT_EQ(log.end, StepEnd::done);
  EXPECT_THAT(log.started_s, testing::Optional(DoubleNear(1763800000.25, 1e-6)));
  EXPECT_EQ(log.elapsed_s, 12.3);
  EXPECT_EQ(log.processor_s, 11.93);
  EXPECT_EQ(log.memory_mb, 153);
  EXPECT_EQ(log.reason, "");
}

TEST(StepLogs, ReadsTheStartInLogsOfOlderRuns) {
  const Folder folder;
  const auto log = read_step_log(folder.write(
      "train.log", "build/bin/train\nstep: begun at 100.5\nstep: exit 0 after 1.0 s\n"));
  EXPECT_THAT(log.started_s, testing::Optional(100.5));
}

TEST(StepLogs, HaveNoProcessorTimeInAnOlderRun) {
  const Folder folder;
  const auto log =
      read_step_log(folder.write("score.log", log_text(1, "step: exit 0 after 0.6 s\n")));
  EXPECT_EQ(log.end, StepEnd::done);
  EXPECT_FALSE(log.processor_s.has_value());
  EXPECT_FALSE(log.memory_mb.has_value());
}

TEST(StepLogs, StartAfterTheWaitInAQueue) {
  const Folder folder;
  const auto log = read_step_log(
      folder.write("train.log", log_text(100, "step: waited 20.5 s\nstep: exit 0 after 0.6 s\n")));
  EXPECT_THAT(log.started_s, testing::Optional(DoubleNear(120.5, 1e-6)));
  EXPECT_EQ(log.elapsed_s, 0.6);
}

TEST(StepLogs, GiveTheReasonOfAFailure) {
  const Folder folder;
  const auto log = read_step_log(
      folder.write("train.log", log_text(1,
                                         "train  ###.  50 %\ntrain: diverged at epoch 3: lower "
                                         "--learning-rate\nstep: exit 1 after 2.0 s\n")));
  EXPECT_EQ(log.end, StepEnd::failed);
  EXPECT_EQ(log.reason, "diverged at epoch 3: lower --learning-rate");
}

TEST(StepLogs, RecordThatTheStepContinuedFromACheckpoint) {
  const Folder folder;
  const auto log = read_step_log(folder.write(
      "train.log", log_text(1,
                            "train: going on from model.h5.checkpoint after 3 epochs\ntrain: "
                            "diverged at epoch 4\nstep: exit 1 after 2.0 s\n")));
  EXPECT_TRUE(log.went_on);
  EXPECT_EQ(log.reason, "diverged at epoch 4");
  EXPECT_FALSE(read_step_log(folder.write("train.log", log_text(1, ""))).went_on);
}

TEST(StepLogs, DistinguishStoppedStepsFromFailedOnes) {
  const Folder folder;
  const auto end_of = [&](const std::string& line) {
    return read_step_log(folder.write("train.log", log_text(1, line))).end;
  };
  EXPECT_EQ(end_of("step: exit 75 after 2.0 s\n"), StepEnd::interrupted);
  EXPECT_EQ(end_of("step: exit 143 after 2.0 s\n"), StepEnd::interrupted);
  EXPECT_EQ(end_of("step: exit 138 after 2.0 s\n"), StepEnd::interrupted);
  EXPECT_EQ(end_of("step: exit 139 after 2.0 s\n"), StepEnd::failed);
  EXPECT_EQ(end_of(""), StepEnd::open);
}

TEST(StepLogs, AreFoundInTheOrderOfTheirStarts) {
  const Folder folder;
  folder.write("cwru/seed0/split.log", log_text(20, "step: exit 0 after 1.0 s\n"));
  folder.write("cwru/ingest.log", log_text(10, "step: exit 0 after 1.0 s\n"));
  folder.write("cwru/other.log", "of another program\n");
  const auto logs = read_step_logs(folder.path());
  ASSERT_EQ(logs.size(), 2U);
  EXPECT_EQ(logs[0].file, "cwru/ingest.log");
  EXPECT_EQ(logs[1].file, "cwru/seed0/split.log");
}

/// A log may have another name than its program, and the command may start with a launcher.
TEST(StepLogs, NameTheProgramByItsCommand) {
  const Folder folder;
  const auto log = read_step_log(folder.write(
      "sweep@smote.log",
      "srun --mem=2G build/bin/sweep --run results/t\nstep: started at 1\nsweep  ##..  50 %\n"
      "sweep: no cell\nstep: exit 66 after 0.1 s\n"));
  EXPECT_EQ(log.stage, "sweep@smote");
  EXPECT_EQ(log.reason, "no cell");
  EXPECT_EQ(log.last_progress, "sweep  ##..  50 %");
  EXPECT_EQ(log.exit_code, 66);
}

/// A terminal would obey control characters, and anybody may have written the log.
TEST(StepLogs, DropControlCharacters) {
  const Folder folder;
  const auto log = read_step_log(
      folder.write("train.log", log_text(1, "train: \x1b[31mred\nstep: exit 1 after 2.0 s\n")));
  EXPECT_EQ(log.reason, "?[31mred");
}

}  // namespace
}  // namespace piae::run
