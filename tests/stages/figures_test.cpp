#include <gmock/gmock.h>

#include "stages/tiny.hpp"

/// Numbers of figures as the program writes them, and the report of the same run.
namespace piae::stages {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string published = std::string(PIAE_SOURCE) + "/results/published";

Arguments figures_of(const Arguments& requested) {
  Arguments arguments{"--run", "run", "--dataset", "tiny", "--published", published};
  arguments.insert(arguments.end(), requested.begin(), requested.end());
  return arguments;
}

/// Provides the files of a run where make puts them.
class FinishedRun : public testing::Test {
 protected:
  FinishedRun() {
    tiny.run_chain_before("");
    for (const std::string name : {"A", "B", "C", "D"}) {
      fs::copy(tiny / (name + ".h5"), tiny / ("run/tiny/seed0/" + name + ".h5"));
    }
    for (const std::string name : {"model", "E"}) {
      fs::copy(tiny / (name + ".h5"), tiny / ("run/tiny/seed0/piae-dt/" + name + ".h5"));
    }
  }

  const Tiny tiny;
};
using Figures = FinishedRun;
using Report = FinishedRun;

std::string csv(const Tiny& tiny, const std::string& figure) {
  return bytes_of(tiny / ("run/tiny/figures/" + figure + ".csv"));
}

TEST_F(Figures, UseAllCellsOfTheRunAndAreReproducible) {
  const Outcome first = tiny.run("figures", figures_of({}));
  ASSERT_EQ(first.status, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr("wrote fig11-12-windows@IR007.csv\n"));
  EXPECT_THAT(first.out,
              HasSubstr("left out fig19-sweep: the sweep is missing; run `make sweep`\n"));
  const std::string losses = csv(tiny, "fig07-losses");
  const std::string space = csv(tiny, "fig09-10-twin-space");
  EXPECT_THAT(losses, HasSubstr("\n0,2,4,total,"));  // seed, stage and the last of four epochs
  fs::remove_all(tiny / "run/tiny/figures");
  ASSERT_EQ(tiny.run("figures", figures_of({"--seeds", "0"})).status, 0);
  EXPECT_EQ(csv(tiny, "fig07-losses"), losses);
  EXPECT_EQ(csv(tiny, "fig09-10-twin-space"), space);
}

TEST_F(Figures, ReportMissingCellsByName) {
  ASSERT_EQ(tiny.run("figures", figures_of({})).status, 0);
  fs::remove(tiny / "run/tiny/seed0/piae-dt/score.h5");
  const Outcome outcome = tiny.run("figures", figures_of({"--methods", "none piae-dt", "--ratios",
                                                          "100to1 50to1", "--seeds", "0"}));
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("fig13-14-quality is not drawn: "));
  EXPECT_THAT(outcome.err, HasSubstr("run/tiny/seed0/piae-dt/score.h5: "));
  EXPECT_THAT(outcome.out, HasSubstr("wrote fig15-gains.csv\n"));
  // Figures whose data is missing are removed.
  EXPECT_FALSE(fs::exists(tiny / "run/tiny/figures/fig13-14-quality.csv"));
}

TEST_F(Figures, ReportADamagedCellByName) {
  tiny.write("run/tiny/seed0/piae-dt/model.h5", "damaged");
  const Outcome outcome = tiny.run("figures", figures_of({}));
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("fig07-losses is not drawn: run/tiny/seed0/piae-dt/model.h5"));
  EXPECT_THAT(outcome.out, HasSubstr("wrote accuracies.csv\n"));
}

TEST(FiguresOfNothing, AreAnError) {
  const Tiny tiny;
  fs::create_directories(tiny / "run/tiny");
  const Outcome outcome = tiny.run("figures", figures_of({}));
  EXPECT_EQ(outcome.status, 66);
  EXPECT_EQ(outcome.err, "figures: run/tiny: holds no cell; run `make cells`\n");
}

Arguments report_of(const Arguments& requested) {
  Arguments arguments{"--run",   "run",     "--published",
                      published, "--style", std::string(PIAE_SOURCE) + "/pipeline/report"};
  arguments.insert(arguments.end(), requested.begin(), requested.end());
  return arguments;
}

TEST_F(Report, UsesAllCellsOfTheRunAndNamesMissingOnes) {
  const Outcome whole = tiny.run("report", report_of({}));
  ASSERT_EQ(whole.status, 0) << whole.err;
  EXPECT_THAT(whole.out, HasSubstr("reported 1 data sets, 0 cells missing"));
  const std::string html = bytes_of(tiny / "run/report.html");
  EXPECT_THAT(html, HasSubstr("All 2 diagnoses and 1 score are there."));
  EXPECT_THAT(html, Not(HasSubstr("http://")));
  const Outcome more = tiny.run("report", report_of({"--seeds", "0 1"}));
  ASSERT_EQ(more.status, 0) << more.err;
  EXPECT_THAT(more.out, HasSubstr("3 cells missing"));
  EXPECT_THAT(bytes_of(tiny / "run/report.md"), HasSubstr("3 of 6 cells are missing"));
}

TEST_F(Report, NamesADatasetThatWasNotStarted) {
  tiny.write("run/hit-sm/ingest.log", "ingest: none-900.csv: no such file\nstep: exit 66\n");
  fs::create_directories(tiny / "run/simulated/seed0");
  const Outcome outcome = tiny.run("report", report_of({}));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("reported 1 data sets, 0 cells missing"));
  EXPECT_THAT(outcome.err, HasSubstr("run/hit-sm: no method was started"));
  EXPECT_THAT(outcome.err, HasSubstr("run/simulated: no method was started"));
}

TEST(ReportOfAFolder, ThatIsMissingIsAnError) {
  const Tiny tiny;
  const Outcome outcome = tiny.run("report", report_of({}));
  EXPECT_EQ(outcome.status, 66);
  EXPECT_THAT(outcome.err, HasSubstr("run"));
}

}  // namespace
}  // namespace piae::stages
