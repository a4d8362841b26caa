#include "page/run_page.hpp"

#include <gmock/gmock.h>
#include <spdlog/fmt/fmt.h>

#include "page/time_line.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::page {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

run::StepLog step(const std::string& file, double started, double elapsed,
                  run::StepEnd end = run::StepEnd::done) {
  const std::filesystem::path path = file;
  return {.file = path,
          .stage = path.stem().string(),
          .end = end,
          .started_s = started,
          .elapsed_s = elapsed};
}

TEST(Durations, UseASuitableUnit) {
  EXPECT_EQ(duration_label(0.42), "0.4 s");
  EXPECT_EQ(duration_label(12.3), "12 s");
  EXPECT_EQ(duration_label(312), "5.2 min");
  EXPECT_EQ(duration_label(11160), "3.1 h");
  EXPECT_EQ(moment_label(1763815560.9), "2025-11-22 12:46 UTC");  // date -u -d @1763815560
}

TEST(TimeLine, SeparatesSessionsAtLongPauses) {
  const auto sessions = sessions_of({step("a.log", 0, 100), step("b.log", 50, 10),
                                     step("c.log", 700, 5), step("d.log", 1306, 5)});
  ASSERT_EQ(sessions.size(), 2U);  // 100 to 700 is ten minutes, 705 to 1306 is more
  EXPECT_EQ(sessions[0].end_s, 705);
  EXPECT_EQ(sessions[1].begin_s, 1306);
}

TEST(TimeLine, OrdersStagesAsTheyRan) {
  EXPECT_THAT(
      stages_in_order({step("sweep.log", 0, 1), step("train.log", 0, 1), step("ingest.log", 0, 1)}),
      ElementsAre("ingest", "train", "sweep"));
}

TEST(TimeLine, PutsOverlappingStepsIntoLanes) {
  const std::string picture = time_line({step("x/train.log", 0, 85), step("y/train.log", 0, 42.5),
                                         step("z/train.log", 60, 25)})
                                  .text();
  // 850 units for 85 s from x = 90, to leave room for the last label; two lanes of 13 units.
  EXPECT_THAT(picture,
              HasSubstr("<rect class=\"bar done\" x=\"90\" y=\"0\" width=\"850\" height=\"11.7\">"
                        "<title>x/train.log, done after 85 s</title>"));
  EXPECT_THAT(picture, HasSubstr("x=\"90\" y=\"13\" width=\"425\""));
  EXPECT_THAT(picture, HasSubstr("x=\"690\" y=\"13\" width=\"250\""));
}

TEST(RunPage, SumsTimeAndMemoryByStageAndMethod) {
  std::vector<run::StepLog> steps{step("cwru/seed0/vae/train.log", 0, 60),
                                  step("cwru/seed1/vae/train.log", 60, 30),
                                  step("cwru/seed0/smote/train.log", 90, 2)};
  steps[0].processor_s = 58;
  steps[1].processor_s = 29;
  steps[1].memory_mb = 153.4;
  const std::string page = run_page(steps, {});
  EXPECT_THAT(
      page, HasSubstr("3 steps took 92 s; one after another they would take 92 s, of which 87 s is "
                      "processor time. No step used more than 153 MB of memory."));
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">train vae</th>"
                              "<td class=\"number\" data-sort=\"2\">2</td><td class=\"number\" "
                              "data-sort=\"0\">0</td><td class=\"number\" data-sort=\"90\">90 "
                              "s</td><td class=\"number\" data-sort=\"87\">87 s</td><td "
                              "class=\"number\" data-sort=\"45\">45 s</td><td class=\"number\" "
                              "data-sort=\"60\">60 s</td><td class=\"number\" "
                              "data-sort=\"153.4\">153 MB</td>"));
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">train smote</th>"));
}

/// Returns a cell of the table of costs.
std::string shown_time(double seconds) {
  return fmt::format("<td class=\"number\" data-sort=\"{}\">{}</td>", seconds,
                     duration_label(seconds));
}

/// Returns a step that used this processor time and took twice as long.
run::StepLog used(const std::string& file, double seconds, run::StepEnd end = run::StepEnd::done) {
  run::StepLog log = step(file, 0, 2 * seconds, end);
  log.processor_s = seconds;
  return log;
}

/// Two seeds with 40 and 60 s of training give 50 s, with 2 s of generating. The ratio with the
/// most windows counts. Unfinished steps and steps of a sweep do not.
TEST(RunPage, SumsTheTimeOfAMethodAndClassifierPerSeed) {
  const std::string page =
      run_page({used("cwru/seed0/vae/train.log", 40), used("cwru/seed1/vae/train.log", 60),
                used("cwru/seed0/vae/generate.log", 2),
                used("cwru/seed1/vae/generate.log", 77, run::StepEnd::failed),
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
              Not(HasSubstr("Processor time of each method")));
}

/// The log of such a step has only the time since the step continued.
TEST(RunPage, IgnoresTheTimeOfAResumedStep) {
  run::StepLog second_half = used("cwru/seed0/vae/train.log", 30);
  second_half.went_on = true;
  const std::vector<run::StepLog> steps{second_half, used("cwru/seed1/vae/train.log", 60),
                                        used("cwru/seed0/vae/generate.log", 2),
                                        used("cwru/seed0/vae/1to1/wdcnn/diagnose.log", 8)};
  EXPECT_THAT(run_page(steps, {}), HasSubstr(shown_time(60) + shown_time(2) + shown_time(8)));
}

TEST(RunPage, ShowsTheSlowestStepsFirst) {
  const std::string page = run_page({step("a/score.log", 0, 1), step("b/score.log", 1, 3)}, {});
  const std::size_t slowest = page.find("The slowest steps</caption>");
  const std::size_t second = page.find("a/score.log", slowest);
  ASSERT_NE(second, std::string::npos);
  EXPECT_LT(page.find("b/score.log", slowest), second);
}

TEST(RunPage, ShowsWhyAStepFailed) {
  run::StepLog failed = step("cwru/seed0/vae/train.log", 0, 1, run::StepEnd::failed);
  failed.reason = "<b>diverged</b>";
  const std::string page = run_page({failed}, {});
  EXPECT_THAT(page, HasSubstr("<rect class=\"bar failed\""));
  EXPECT_THAT(page, HasSubstr("&lt;b&gt;diverged&lt;/b&gt;"));
  EXPECT_THAT(page, Not(HasSubstr("<b>diverged")));
}

/// A row and a bar for each of a hundred thousand steps would make a page of 60 MB.
TEST(RunPage, ListsOnlyUnfinishedStepsIfThereAreMany) {
  std::vector<run::StepLog> steps;
  for (int i = 0; i < 100'000; ++i) {
    steps.push_back(step(fmt::format("cwru/seed{}/split.log", i), i, 1));
  }
  steps[70'000].end = run::StepEnd::failed;
  const std::string page = run_page(steps, {});
  EXPECT_LT(page.size(), 1'000'000U);
  EXPECT_THAT(page, HasSubstr("100000 steps are too many for a page: their logs are next to their "
                              "outputs. 1 are not done."));
  EXPECT_THAT(page, HasSubstr("<rect class=\"bar failed\""));
  EXPECT_THAT(page, HasSubstr("cwru/seed70000/split.log</a>"));
  EXPECT_THAT(page, HasSubstr("<title>cwru/seed0/split.log, and "));
}

TEST(RunPage, ReportsARunWithoutLogs) {
  EXPECT_THAT(run_page({}, {}), HasSubstr("No step of this run has a log."));
}

}  // namespace
}  // namespace piae::page
