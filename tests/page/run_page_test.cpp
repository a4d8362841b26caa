#include "page/run_page.hpp"

#include <gmock/gmock.h>
#include <spdlog/fmt/fmt.h>

#include "page/duration.hpp"
#include "page/time_line.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::page {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::string log_text(double begun, const std::string& lines) {
  return "build/bin/train --seed 0\nstep: begun at " + std::to_string(begun) + "\n" + lines;
}

StepLog step(const std::string& file, double begun, double elapsed, StepEnd end = StepEnd::done) {
  const std::filesystem::path path = file;
  return {.file = path,
          .stage = path.stem().string(),
          .end = end,
          .begun_s = begun,
          .elapsed_s = elapsed};
}

TEST(StepLog, SaysWhatTheStepTook) {
  const Folder folder;
  const auto log = read_step_log(folder.write(
      "train.log", log_text(1763800000.25,
                            "trained vae on 45 windows: results/t/model.h5\nstep: used 11.93 s of "
                            "processor time and 153 MB of memory\nstep: exit 0 after 12.3 s\n")));
  EXPECT_EQ(log.stage, "train");
  EXPECT_EQ(log.end, StepEnd::done);
  EXPECT_THAT(log.begun_s, testing::Optional(DoubleNear(1763800000.25, 1e-6)));
  EXPECT_EQ(log.elapsed_s, 12.3);
  EXPECT_EQ(log.processor_s, 11.93);
  EXPECT_EQ(log.memory_mb, 153);
  EXPECT_EQ(log.reason, "");
}

TEST(StepLog, OfAnOlderRunHasNoProcessorTime) {
  const Folder folder;
  const auto log =
      read_step_log(folder.write("score.log", log_text(1, "step: exit 0 after 0.6 s\n")));
  EXPECT_EQ(log.end, StepEnd::done);
  EXPECT_FALSE(log.processor_s.has_value());
  EXPECT_FALSE(log.memory_mb.has_value());
}

TEST(StepLog, BeginsWhenItsPlaceInAQueueHasCome) {
  const Folder folder;
  const auto log = read_step_log(
      folder.write("train.log", log_text(100, "step: waited 20.5 s\nstep: exit 0 after 0.6 s\n")));
  EXPECT_THAT(log.begun_s, testing::Optional(DoubleNear(120.5, 1e-6)));
  EXPECT_EQ(log.elapsed_s, 0.6);
}

TEST(StepLog, OfAFailedStepSaysWhy) {
  const Folder folder;
  const auto log = read_step_log(
      folder.write("train.log", log_text(1,
                                         "train  ###.  50 %\ntrain: diverged at epoch 3: lower "
                                         "--learning-rate\nstep: exit 1 after 2.0 s\n")));
  EXPECT_EQ(log.end, StepEnd::failed);
  EXPECT_EQ(log.reason, "diverged at epoch 3: lower --learning-rate");
}

TEST(StepLog, SaysThatTheStepWentOnFromACheckpoint) {
  const Folder folder;
  const auto log = read_step_log(folder.write(
      "train.log", log_text(1,
                            "train: going on from model.h5.checkpoint after 3 epochs\ntrain: "
                            "diverged at epoch 4\nstep: exit 1 after 2.0 s\n")));
  EXPECT_TRUE(log.went_on);
  EXPECT_EQ(log.reason, "diverged at epoch 4");
  EXPECT_FALSE(read_step_log(folder.write("train.log", log_text(1, ""))).went_on);
}

TEST(StepLog, TellsStoppedStepsFromFailedOnes) {
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

TEST(StepLog, FindsAllOfARunInTheOrderInWhichTheyBegan) {
  const Folder folder;
  folder.write("cwru/seed0/split.log", log_text(20, "step: exit 0 after 1.0 s\n"));
  folder.write("cwru/ingest.log", log_text(10, "step: exit 0 after 1.0 s\n"));
  folder.write("cwru/other.log", "of another program\n");
  const auto logs = read_step_logs(folder.path());
  ASSERT_EQ(logs.size(), 2U);
  EXPECT_EQ(logs[0].file, "cwru/ingest.log");
  EXPECT_EQ(logs[1].file, "cwru/seed0/split.log");
}

TEST(Durations, AreInAUnitThatFits) {
  EXPECT_EQ(duration_label(0.42), "0.4 s");
  EXPECT_EQ(duration_label(12.3), "12 s");
  EXPECT_EQ(duration_label(312), "5.2 min");
  EXPECT_EQ(duration_label(11160), "3.1 h");
  EXPECT_EQ(moment_label(1763815560.9), "2025-11-22 12:46 UTC");  // date -u -d @1763815560
}

TEST(TimeLine, PartsSessionsByLongPauses) {
  const auto sessions = sessions_of({step("a.log", 0, 100), step("b.log", 50, 10),
                                     step("c.log", 700, 5), step("d.log", 1306, 5)});
  ASSERT_EQ(sessions.size(), 2U);  // from 100 to 700 are ten minutes, from 705 to 1306 are more
  EXPECT_EQ(sessions[0].end_s, 705);
  EXPECT_EQ(sessions[1].begin_s, 1306);
}

TEST(TimeLine, StagesStandInTheOrderOfTheRun) {
  EXPECT_THAT(
      stages_in_order({step("sweep.log", 0, 1), step("train.log", 0, 1), step("ingest.log", 0, 1)}),
      ElementsAre("ingest", "train", "sweep"));
}

TEST(TimeLine, StepsThatOverlapLieInLanes) {
  const std::string picture = time_line({step("x/train.log", 0, 85), step("y/train.log", 0, 42.5),
                                         step("z/train.log", 60, 25)})
                                  .text();
  // 850 units for 85 s from x = 90, so that the last label has room; two lanes of 13 units.
  EXPECT_THAT(picture,
              HasSubstr("<rect class=\"bar done\" x=\"90\" y=\"0\" width=\"850\" height=\"11.7\">"
                        "<title>x/train.log, done after 85 s</title>"));
  EXPECT_THAT(picture, HasSubstr("x=\"90\" y=\"13\" width=\"425\""));
  EXPECT_THAT(picture, HasSubstr("x=\"690\" y=\"13\" width=\"250\""));
}

TEST(RunPage, SumsTimeAndMemoryByStageAndMethod) {
  std::vector<StepLog> steps{step("cwru/seed0/vae/train.log", 0, 60),
                             step("cwru/seed1/vae/train.log", 60, 30),
                             step("cwru/seed0/smote/train.log", 90, 2)};
  steps[0].processor_s = 58;
  steps[1].processor_s = 29;
  steps[1].memory_mb = 153.4;
  const std::string page = run_page(steps, {});
  EXPECT_THAT(
      page,
      HasSubstr("3 steps took 92 s; one after the other they would take 92 s, of which 87 s is "
                "processor time. No step held more than 153 MB of memory."));
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">train vae</th>"
                              "<td class=\"number\" data-sort=\"2\">2</td><td class=\"number\" "
                              "data-sort=\"0\">0</td><td class=\"number\" data-sort=\"90\">90 "
                              "s</td><td class=\"number\" data-sort=\"87\">87 s</td><td "
                              "class=\"number\" data-sort=\"45\">45 s</td><td class=\"number\" "
                              "data-sort=\"60\">60 s</td><td class=\"number\" "
                              "data-sort=\"153.4\">153 MB</td>"));
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">train smote</th>"));
}

/// A cell of the table of costs.
std::string shown_time(double seconds) {
  return fmt::format("<td class=\"number\" data-sort=\"{}\">{}</td>", seconds,
                     duration_label(seconds));
}

/// A step that used so much processor time, and took twice as long.
StepLog used(const std::string& file, double seconds, StepEnd end = StepEnd::done) {
  StepLog log = step(file, 0, 2 * seconds, end);
  log.processor_s = seconds;
  return log;
}

/// Of two seeds 40 and 60 s of training are 50, and 2 s of generating. Of the ratios that with the
/// most windows counts; what is not done does not; and what a sweep took is no method's.
TEST(RunPage, SumsWhatAMethodWithAClassifierTakesOfASeed) {
  const std::string page =
      run_page({used("cwru/seed0/vae/train.log", 40), used("cwru/seed1/vae/train.log", 60),
                used("cwru/seed0/vae/generate.log", 2),
                used("cwru/seed1/vae/generate.log", 77, StepEnd::failed),
                used("cwru/seed0/vae/10to1/wdcnn/diagnose.log", 5),
                used("cwru/seed0/vae/1to1/wdcnn/diagnose.log", 8),
                used("cwru/seed0/vae/1to1/nearest/diagnose.log", 3),
                used("cwru/seed0/sweep/batch-1/1to1/wdcnn/diagnose.log", 70),
                used("cwru/seed0/none/100to1/wdcnn/diagnose.log", 6),
                used("cwru/seed0/smote/1to1/wdcnn/diagnose.log", 7)},
               {});
  const std::string unknown = "<td class=\"number\">–</td>";
  const auto row = [](const std::string& method, const std::string& classifier,
                      const std::string& ratio) {
    return "<th scope=\"row\">" + method + "</th><td>" + classifier + "</td><td>" + ratio +
           "</td><td>cwru</td>";
  };
  EXPECT_THAT(page, HasSubstr(row("vae", "wdcnn", "1:1") + shown_time(50) + shown_time(2) +
                              shown_time(8) + shown_time(60)));
  EXPECT_THAT(page, HasSubstr(row("vae", "nearest", "1:1") + shown_time(50) + shown_time(2) +
                              shown_time(3) + shown_time(55)));
  EXPECT_THAT(page, HasSubstr(row("none", "wdcnn", "100:1") + unknown + unknown + shown_time(6) +
                              shown_time(6)));
  EXPECT_THAT(page,
              HasSubstr(row("smote", "wdcnn", "1:1") + unknown + unknown + shown_time(7) + unknown))
      << "its other logs are not there";
  EXPECT_THAT(page, Not(HasSubstr("<td>10:1</td>")));
  EXPECT_THAT(page, Not(HasSubstr("<td>batch-1</td>")));
  EXPECT_THAT(run_page({used("cwru/seed0/vae/train.log", 40)}, {}),
              Not(HasSubstr("that each method takes")));
}

/// Its log has what it took since then alone.
TEST(RunPage, TakesNoTimeFromAStepThatWentOn) {
  StepLog second_half = used("cwru/seed0/vae/train.log", 30);
  second_half.went_on = true;
  const std::vector<StepLog> steps{second_half, used("cwru/seed1/vae/train.log", 60),
                                   used("cwru/seed0/vae/generate.log", 2),
                                   used("cwru/seed0/vae/1to1/wdcnn/diagnose.log", 8)};
  EXPECT_THAT(run_page(steps, {}), HasSubstr(shown_time(60) + shown_time(2) + shown_time(8)));
}

TEST(RunPage, ShowsTheSlowestStepsFirst) {
  const std::string page = run_page({step("a/score.log", 0, 1), step("b/score.log", 1, 3)}, {});
  const std::size_t slowest = page.find("The slowest steps</caption>");
  EXPECT_LT(page.find("b/score.log", slowest), page.find("a/score.log", slowest));
}

TEST(RunPage, ShowsWhyAStepFailed) {
  StepLog failed = step("cwru/seed0/vae/train.log", 0, 1, StepEnd::failed);
  failed.reason = "<b>diverged</b>";
  const std::string page = run_page({failed}, {});
  EXPECT_THAT(page, HasSubstr("<rect class=\"bar failed\""));
  EXPECT_THAT(page, HasSubstr("&lt;b&gt;diverged&lt;/b&gt;"));
  EXPECT_THAT(page, Not(HasSubstr("<b>diverged")));
}

/// With a row and a bar each, a hundred thousand steps would be a page of 60 MB.
TEST(RunPage, OfManyStepsListsThoseThatAreNotDone) {
  std::vector<StepLog> steps;
  for (int i = 0; i < 100'000; ++i) {
    steps.push_back(step(fmt::format("cwru/seed{}/split.log", i), i, 1));
  }
  steps[70'000].end = StepEnd::failed;
  const std::string page = run_page(steps, {});
  EXPECT_LT(page.size(), 1'000'000U);
  EXPECT_THAT(page, HasSubstr("100000 steps are too many for a page: their logs lie beside what "
                              "they made. 1 are not done."));
  EXPECT_THAT(page, HasSubstr("<rect class=\"bar failed\""));
  EXPECT_THAT(page, HasSubstr("cwru/seed70000/split.log</a>"));
  EXPECT_THAT(page, HasSubstr("<title>cwru/seed0/split.log, and "));
}

TEST(RunPage, OfARunWithoutLogsSaysSo) {
  EXPECT_THAT(run_page({}, {}), HasSubstr("No step of this run has left a log."));
}

}  // namespace
}  // namespace piae::page
