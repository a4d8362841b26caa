#include "page/report_page.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "page/problems.hpp"
#include "support/errors.hpp"
#include "support/published_tables.hpp"
#include "support/stored_run.hpp"
#include "support/stored_tested_windows.hpp"
#include "text/escape.hpp"

namespace piae::page {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Le;
using testing::Not;
using testing::SizeIs;

/// A run of `none` and `vae` on cwru: seeds 0 and 1, ratios 100to1, 10to1 and 2to1.
class ReportPage : public StoredRun {
 protected:
  ReportPage() : run_(folder_.path() / "run") { write_published_tables(folder_); }

  [[nodiscard]] ReportContents read(const RequestedCells& requested = {}) const {
    return read_report(run_, requested, report::Published(folder_.path()));
  }
  [[nodiscard]] std::string page(const RequestedCells& requested = {}) const {
    return report_page(read(requested), {});
  }
  [[nodiscard]] std::string text(const RequestedCells& requested = {}) const {
    return report_text(read(requested));
  }
  fs::path write(const std::string& name, const std::string& content) const {
    return folder_.write("run/" + name, content);
  }
  /// Adds the log of a failed step.
  void add_failed(const std::string& name, const std::string& line) const {
    write(name, "command\nstep: started at 1\n" + line + "\nstep: exit 1 after 2.0 s\n");
  }

  const fs::path run_;
};

TEST_F(ReportPage, ShowsTheMeanOfEachCellAndThePublishedValue) {
  add_all();
  const std::string html = page();
  // vae at 2to1: 17 and 19 of 20 windows are 85 and 95 %, mean 90, standard deviation sqrt(50).
  EXPECT_THAT(html, HasSubstr("<span class=\"ours\">90.00 ± 7.07</span>"
                              "<span class=\"theirs\">paper 91.20</span>"));
  EXPECT_THAT(html, HasSubstr("<span class=\"ours\">62.50 ± 3.54</span>"
                              "<span class=\"theirs\">paper 61.80</span>"));
}

/// The 20 windows of a seed follow each other in one record. vae at 2to1 recognises 17 and 19 with
/// the same score of 1, so both decisions over ten windows are correct.
TEST_F(ReportPage, ShowsDecisionsOverSeveralWindowsAndWhatMayBeAnswered) {
  for (const int seed : {0, 1}) {
    scoring::DiagnosisRecord record = diagnosis("vae", "2to1", 145, seed, seed == 0 ? 17 : 19);
    for (std::size_t i = 0; i < 20; ++i) record.scores[3 * i + index_of(record.predictions[i])] = 1;
    add(record);
  }
  std::string html = page();
  EXPECT_THAT(html, HasSubstr("are left out: the run does not hold the test windows"));
  EXPECT_THAT(html,
              HasSubstr("No confidence is reported by vae: all windows are answered, or none."));
  EXPECT_THAT(html, Not(HasSubstr("10 windows")));
  for (const int seed : {0, 1}) {
    save_tested_windows(layout_, "cwru", seed, std::vector<Label>(20, 1), one_record(20));
  }
  html = page();
  EXPECT_THAT(html, HasSubstr("title=\"2 decisions of each of 2 seeds\">100.00 ± 0.00"));
  EXPECT_THAT(html, HasSubstr("title=\"20 decisions of each of 2 seeds\">90.00 ± 7.07"));
  EXPECT_THAT(html, HasSubstr("title=\"/scores of 2 seeds\">50.00 ± 70.71"));  // 0 and 100
  EXPECT_THAT(html, HasSubstr("title=\"/scores of 2 seeds\">10.00 ± 7.07"));
}

TEST_F(ReportPage, StartsWithTheConditionsOfFaults) {
  scoring::DiagnosisRecord record = diagnosis("none", "100to1", 0, 0, 12);
  record.info.conditions = {{"1200 rpm", 1200, true, false, true},
                            {"900 rpm", 900, false, true, true}};
  add(record);
  const std::string sentence = "Faults are known at 1200 rpm, and tested at 900 rpm.";
  EXPECT_THAT(page(), HasSubstr("<p class=\"verdict\">" + sentence + "</p>"));
  EXPECT_THAT(text(), HasSubstr(sentence));
}

TEST_F(ReportPage, ShowsGainsWithASignAndAColour) {
  add_all();
  // 85 - 60 and 95 - 65 points; published 91.2 - 61.8.
  EXPECT_THAT(page(), HasSubstr("<span class=\"ours\">○ +27.50 ± 3.54</span>"
                                "<span class=\"theirs\">paper +29.40</span>"));
  // A third seed with 95 - 65 points gives an interval, from 21 to 36.
  add(diagnosis("none", "100to1", 0, 2, 13));
  add(diagnosis("vae", "2to1", 145, 2, 19));
  EXPECT_THAT(page(), HasSubstr("<span class=\"ours\">▲ +28.33 ± 2.89</span>"));
}

/// vae at 2to1: 90 %. Wrong windows are taken for the outer race, so no fault is missed.
TEST_F(ReportPage, RecommendsAMethod) {
  add_all();
  const std::string html = page();
  EXPECT_THAT(html, HasSubstr("<h2>Which method to take</h2>\n<p class=\"verdict\">Recommended on "
                              "cwru: vae, correct in 90.0 % of the test windows (2 seeds)"));
  EXPECT_THAT(html, HasSubstr("With 2 seeds it cannot be decided if those that need less are as "
                              "good: none (-27.5 points). At least 6 seeds are needed."));
  EXPECT_THAT(html, HasSubstr("<td class=\"helps\">yes</td>"));
  EXPECT_THAT(html, HasSubstr("title=\"0 of 40 windows\">0.0</td>"));
  EXPECT_THAT(html, HasSubstr("Which method to take at each ratio on cwru<"));
  EXPECT_THAT(text(), HasSubstr("\n## Which method to take on cwru\n\nRecommended on cwru: vae"));
}

TEST_F(ReportPage, NamesTheArtefactsBehindANumber) {
  add_all();
  const std::string html = page();
  EXPECT_THAT(
      html, HasSubstr("title=\"cwru/seed{0,1}/vae/2to1/wdcnn/diagnosis.h5, attribute accuracy\""));
  EXPECT_THAT(html, HasSubstr("<a href=\"./cwru/seed1/vae/2to1/wdcnn/diagnosis.h5\">"
                              "cwru/seed1/vae/2to1/wdcnn/diagnosis.h5</a>"));
  const artefact::Reader reader(layout_.diagnosis("vae", "2to1", 1), "diagnosis");
  EXPECT_THAT(html, HasSubstr("<code>" + reader.digest().substr(0, 16) + "</code>"));
}

TEST_F(ReportPage, ShowsTheBaselineAndEachOtherClassifier) {
  add_all();
  EXPECT_THAT(page(), Not(HasSubstr("nearest")));
  for (const int seed : {0, 1}) add(by("nearest", diagnosis("none", "100to1", 0, seed, 19)));
  std::string html = page();
  EXPECT_THAT(html, HasSubstr("none by nearest"));
  EXPECT_THAT(html, HasSubstr("title=\"cwru/seed{0,1}/none/100to1/nearest/diagnosis.h5, "
                              "attribute accuracy\""));
  EXPECT_THAT(html, HasSubstr("<a href=\"./cwru/seed1/none/100to1/nearest/diagnosis.h5\">"));
  EXPECT_THAT(html, Not(HasSubstr(", by nearest")));
  EXPECT_THAT(html, HasSubstr("✔ All 8 diagnoses and 2 scores are there."));
  for (const int seed : {0, 1}) {
    add(by("wdcnn-spectrum", diagnosis("none", "100to1", 0, seed, 18)));
    add(by("wdcnn-spectrum", diagnosis("vae", "10to1", 45, seed, 20)));
  }
  html = page();
  EXPECT_THAT(html, HasSubstr("standard deviation over seeds, by wdcnn-spectrum"));
  EXPECT_THAT(html, HasSubstr("interval of its mean, by wdcnn-spectrum"));
  EXPECT_THAT(html, HasSubstr("<span class=\"ours\">○ +10.00 ± 0.00</span>"));
  // The classifier has a cell of vae, so the other ratio of vae is missing.
  EXPECT_THAT(html, HasSubstr("vae by wdcnn-spectrum; 2:1; seeds 0, 1"));
}

TEST_F(ReportPage, ShowsTheVerdictOfTheSummary) {
  add_all();
  EXPECT_THAT(page(),
              HasSubstr("With 145 generated windows of each fault, in points "
                        "against the 62.5 % without any: vae (+27.5). These are two seeds"));
}

TEST_F(ReportPage, ReportsACompleteRun) {
  add_all();
  EXPECT_THAT(page(), HasSubstr("✔ All 6 diagnoses and 2 scores are there."));
  EXPECT_THAT(page(), Not(HasSubstr("missing:")));
}

TEST_F(ReportPage, NamesMissingCellsAndWhyAtTheTop) {
  add_baseline();
  add(diagnosis("vae", "10to1", 45, 0, 15));
  add(quality("vae", 0, 0.5));
  add_failed("cwru/seed1/vae/train.log", "train: diverged at epoch 3 <b>");
  const std::string html = page();
  EXPECT_LT(html.find("⚠ 2 of 6 cells are missing: 2 failed."), html.find("<h2>"));
  EXPECT_THAT(html, HasSubstr("vae; 10:1; seed 1"));
  EXPECT_THAT(html, HasSubstr("1 diagnosis and 1 score"));
  EXPECT_THAT(html, HasSubstr("diverged at epoch 3 &lt;b&gt;"));
  EXPECT_THAT(html,
              HasSubstr("<a href=\"./cwru/seed1/vae/train.log\">cwru/seed1/vae/train.log</a>"));
}

TEST_F(ReportPage, ShowsTheNumberOfSeedsOfAnUnfinishedRun) {
  add_baseline();
  add(diagnosis("vae", "10to1", 45, 1, 15));
  // One seed: 75 %, and 75 - 65 points, paired with the same seed of none. One seed shows no
  // effect.
  EXPECT_THAT(
      page(),
      HasSubstr("<span class=\"ours\">75.00</span><span class=\"theirs\">1 of 2 seeds</span>"));
  EXPECT_THAT(page(), HasSubstr("<span class=\"ours\">○ +10.00</span>"));
}

TEST_F(ReportPage, CountsRequestedCellsThatDidNotStartAsMissing) {
  add_all();
  const RequestedCells requested{
      .cells = {.methods = {"none vae smote"}, .ratios = {"100to1 10to1"}, .seeds = {"0 1 2"}}};
  const auto groups = groups_of(read(requested).datasets);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].state, MissingState::not_started);
  EXPECT_EQ(cells_label(groups[0]), "none, vae and smote; 100:1 and 10:1; seeds 0 to 2");
  // none and vae lack seed 2, smote all three. Scores lack the same seeds, but none has no scores.
  EXPECT_EQ(groups[0].diagnoses, 5U);
  EXPECT_EQ(groups[0].scores, 4U);
  // Other cells in the folder, vae at 2to1, are shown, too.
  EXPECT_THAT(page(requested), HasSubstr("paper 91.20"));
}

TEST_F(ReportPage, NamesADamagedCell) {
  add_all();
  write("cwru/seed1/vae/2to1/wdcnn/diagnosis.h5", "no artefact");
  const std::string html = page();
  EXPECT_THAT(html, HasSubstr("⚠ 1 of 8 cells is missing: 1 refused."));
  EXPECT_THAT(html, HasSubstr("✖ refused"));
  EXPECT_THAT(html, HasSubstr("cwru/seed1/vae/2to1/wdcnn/diagnosis.h5: "));
}

TEST_F(ReportPage, DistinguishesFailedInterruptedAndRunningSteps) {
  add_baseline();
  write("cwru/seed0/vae/train.log", "command\nstep: started at 1\nstep: exit 75 after 1.0 s\n");
  write("cwru/seed1/vae/train.log", "command\nstep: started at 1\n");
  const RequestedCells requested{
      .cells = {.methods = {"none vae"}, .ratios = {"100to1 10to1"}, .seeds = {"0 1"}}};
  EXPECT_THAT(page(requested),
              HasSubstr("4 of 6 cells are missing: 2 interrupted and 2 running or killed."));
}

TEST_F(ReportPage, ReportsMissingRecordings) {
  add_failed("cwru/ingest.log", "ingest: data/cwru/97.mat: no such file");
  const RequestedCells requested{
      .datasets = {"cwru"}, .cells = {.methods = {"none"}, .ratios = {"100to1"}, .seeds = {"0"}}};
  const std::string html = page(requested);
  EXPECT_THAT(html, HasSubstr("data/cwru/97.mat: no such file"));
  EXPECT_THAT(html, HasSubstr("No diagnosis has finished yet."));
}

TEST_F(ReportPage, FailsWithoutACell) {
  fs::create_directories(run_);
  EXPECT_ERROR(page(), Exit::input_missing, "holds no cell of any data set");
  EXPECT_ERROR(page({.datasets = {"cwru"}}), Exit::input_missing, "holds no cell");
}

TEST_F(ReportPage, LeavesOutADataSetWithoutRequestedCells) {
  add_all();
  write("simulated/seed0/vae/train.log", "");  // as `make identify` leaves it
  write("simulated/identifiability.csv", "");
  EXPECT_THAT(page(), AllOf(HasSubstr("cwru"), Not(HasSubstr("simulated"))));
}

/// No folder records the requested ratios, so all are missing.
TEST_F(ReportPage, NamesADataSetWithoutTraining) {
  add_all();
  add_failed("hit-sm/seed0/vae/train.log", "train: hit-sm/seed0/C.h5: damaged");
  EXPECT_THAT(page(), AllOf(HasSubstr("7 of 15 cells are missing: 7 failed."),
                            HasSubstr("vae; 50:1, 25:1, 10:1, 5:1, 2:1 and 1:1; seed 0"),
                            HasSubstr("hit-sm/seed0/C.h5: damaged")));
  write("hit-sm/identifiability.csv", "");
  write("hit-sm/seed0/vae/2to1/wdcnn/diagnose.log", "command\nstep: started at 1\n");
  EXPECT_THAT(page(), HasSubstr("2 of 10 cells are missing"));
}

TEST_F(ReportPage, EscapesHostileNames) {
  const std::string hostile = "<script>alert('1')</script>\" onload=\"x";
  add(diagnosis("none", "100to1", 0, 0, 12));
  // A class of this name is refused, so the page does not even show it.
  scoring::DiagnosisRecord record = diagnosis("none", "100to1", 1, 0, 12);
  record.info.classes[1].name = hostile;
  add(record);
  add_failed("cwru/seed2/vae/train.log", "train: " + hostile);
  write("cwru/figures/fig15-gains@" + std::string("\"><img src=x>.svg"), "<svg/>");
  write(".settings/datasets/cwru.toml", "name = \"" + std::string("<script>") + "\"\n");
  const std::string html = page();
  EXPECT_THAT(html, HasSubstr("&lt;script&gt;alert('1')&lt;/script&gt;&quot; onload=&quot;x"));
  EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(html, Not(HasSubstr("<img src=x")));
  // The only script of the page is its own, which is empty here.
  EXPECT_EQ(html.find("<script"), html.rfind("<script"));
}

TEST_F(ReportPage, WritesTheSameBytesInAnyFolder) {
  add_all();
  add_failed("cwru/seed2/vae/train.log",
             "train: " + (run_ / "cwru/seed2/C.h5").string() + ": damaged");
  write("cwru/figures/fig15-gains.svg", "<svg/>");
  const std::string here = page();
  const std::string text_here = text();
  const fs::path elsewhere = folder_.path() / "another" / "place";
  fs::create_directories(elsewhere.parent_path());
  fs::copy(run_, elsewhere, fs::copy_options::recursive);
  // The steps of the copy ran in the other folder.
  std::ofstream(elsewhere / "cwru/seed2/vae/train.log")
      << "command\nstep: started at 1\ntrain: " << (elsewhere / "cwru/seed2/C.h5").string()
      << ": damaged\nstep: exit 1 after 2.0 s\n";
  const report::Published published(folder_.path());
  const ReportContents there = read_report(elsewhere, {}, published);
  EXPECT_EQ(report_page(there, {}), here);
  EXPECT_EQ(report_text(there), text_here);
  EXPECT_THAT(here, Not(HasSubstr(folder_.path().string())));
}

TEST_F(ReportPage, DoesNotShowDurations) {
  add_all();
  write("cwru/seed0/split.log",
        "command\nstep: started at 1763800000.5\nstep: exit 0 after 12.3 s\n");
  const std::string before = page();
  write("cwru/seed0/split.log",
        "command\nstep: started at 1863800000.5\nstep: exit 0 after 99.9 s\n");
  EXPECT_EQ(page(), before);
}

TEST_F(ReportPage, DoesNotLoadAnythingFromElsewhere) {
  add_all();
  write("cwru/figures/fig15-gains.svg", "<svg xmlns='http://www.w3.org/2000/svg'/>");
  write("cwru/figures/fig15-gains.csv", "a,b\n");
  const std::string html = page();
  for (std::size_t at = html.find(" src=\""); at != std::string::npos;
       at = html.find(" src=\"", at + 1)) {
    EXPECT_EQ(html.substr(at + 6, 5), "data:");
  }
  EXPECT_THAT(html, Not(HasSubstr("href=\"http")));
  EXPECT_THAT(html, Not(HasSubstr("@import")));
}

TEST_F(ReportPage, HoldsEachFigureWithAnAnchorItsCaptionAndItsNumbers) {
  add_all();
  write("cwru/figures/fig15-gains.svg",
        "<svg viewBox=\"0 0 960 600\"><rect fill='rgb(  1, 2, 3)'/></svg>");
  write("cwru/figures/fig15-gains.csv", "method,gain\nvae,27.5\n");
  const std::string html = page();
  EXPECT_THAT(html, HasSubstr("<section id=\"cwru-figure-fig15-gains\" class=\"card\">"));
  EXPECT_THAT(html, HasSubstr("Fig. 15: Gain of generated windows, by ratio"));
  EXPECT_THAT(
      html,
      HasSubstr("src=\"data:image/svg+xml;charset=utf-8,%3Csvg viewBox=%220 0 960 600%22%3E%3Crect "
                "fill='rgb(  1, 2, 3)'/"));
  EXPECT_THAT(html, HasSubstr(" width=\"960\" height=\"600\">"));
  EXPECT_THAT(html, HasSubstr("<a href=\"data:text/csv;charset=utf-8,method,gain%0Avae,27.5%0A\" "
                              "download=\"cwru-fig15-gains.csv\">CSV</a>"));
  EXPECT_THAT(html, HasSubstr("From cwru/seed*/&lt;method&gt;/&lt;ratio&gt;/"
                              "&lt;classifier&gt;/diagnosis.h5"));
  EXPECT_THAT(html, HasSubstr("alt=\"Fig. 15: Gain of generated windows, by ratio, on cwru. "));
}

TEST_F(ReportPage, NamesStaleCellsWithoutTheirNumbers) {
  add_all();
  const RequestedCells requested{.leave_out = {"cwru/seed0/vae", "cwru/seed1/vae"}};
  for (const std::string& shown : {page(requested), text(requested)}) {
    EXPECT_THAT(
        shown,
        HasSubstr("left out, because they are damaged or were made with other settings or inputs"));
    EXPECT_THAT(shown, Not(HasSubstr("90.0")));  // the mean of vae at 2to1
  }
  EXPECT_THAT(text(requested), HasSubstr("All 2 diagnoses"));
}

TEST_F(ReportPage, ShowsSeveralPicturesOfAFigure) {
  add_all();
  write("cwru/figures/fig15-gains@OR.svg", "<svg/>");
  write("cwru/figures/fig15-gains@IR.svg", "<svg/>");
  const std::string html = page();
  const std::size_t second = html.find("<figure id=\"cwru-fig15-gains-or\">");
  ASSERT_NE(second, std::string::npos);
  EXPECT_LT(html.find("<figure id=\"cwru-fig15-gains-ir\">"), second);
}

TEST_F(ReportPage, NamesFiguresThatAreNotDrawnAndWhy) {
  add_all();
  write("cwru/figures.log",
        "figures: fig07-losses is not drawn: needs the method piae-dt, which is not in the "
        "grid\nfigures: fig13-14-quality is not drawn: " +
            (run_ / "cwru/seed0/vae/score.h5").string() +
            ": no such file\nleft out fig19-sweep: the sweep is missing; run `make sweep`\n");
  write("cwru/figures/fig15-gains.csv", "a,b\n");
  const std::string html = page();
  EXPECT_THAT(html, HasSubstr("<b>needs the method piae-dt, which is not in the grid</b>: Fig. 7: "
                              "Losses of PIAE-DT by epoch (fig07-losses)</li>"));
  EXPECT_THAT(html, HasSubstr("<b>cwru/seed0/vae/score.h5: no such file</b>: Figs 13 and 14: "));
  EXPECT_THAT(html, HasSubstr("<b>its numbers exist, but gnuplot has not drawn them</b>: "
                              "Fig. 15: "));
  EXPECT_THAT(html, HasSubstr("<b>make figures has not run since its cells exist</b>: "));
  // A figure that the run does not need is not a problem.
  EXPECT_THAT(html, HasSubstr("<p>Left out, because this run lacks what they show</p>\n<ul><li>"
                              "<b>the sweep is missing; run `make sweep`</b>: Fig. 19: "));
}

TEST_F(ReportPage, ComputesRecallFromSummedConfusions) {
  add_all();
  const std::string html = page();
  // All windows are of class IR. At 2to1 17 and 19 of 20 are recognised, 36 of 40; the others are
  // taken for OR, also a fault.
  EXPECT_THAT(html, HasSubstr("data-sort=\"90\" title=\"36 of 40 windows\">90.0</td>"));
  EXPECT_THAT(html, HasSubstr("data-sort=\"0\" title=\"0 of 40 windows\">0.0</td>"));
  // none: 12 and 13 of 20, shaded because less than 80 % are recognised.
  EXPECT_THAT(
      html,
      HasSubstr("class=\"low-1 number\" data-sort=\"62.5\" title=\"25 of 40 windows\">62.5</td>"));
}

TEST_F(ReportPage, CountsMissedFaultsAndFalseAlarms) {
  scoring::DiagnosisRecord record = diagnosis("none", "100to1", 0, 0, 20);
  // 4 of 20 windows are healthy, and 1 of them is taken for a fault. Of the 16 others 4 are taken
  // for healthy.
  std::fill_n(record.labels.begin(), 4, 0);
  std::fill_n(record.predictions.begin(), 3, 0);
  std::fill_n(record.predictions.begin() + 4, 4, 0);
  add(record);
  EXPECT_THAT(page(), AllOf(HasSubstr("title=\"4 of 16 windows\">25.0</td>"),
                            HasSubstr("title=\"1 of 4 windows\">25.0</td>")));
}

TEST_F(ReportPage, ShowsSettingsFilesUnchanged) {
  add_all();
  write(".settings/train.vae.toml", "# <b>more</b>\nbatch = 5\nwidth = 7.94\n");
  write(".settings/datasets/cwru.toml", "unit = 9.8\n");
  const std::string html = page();
  EXPECT_THAT(html, HasSubstr("<summary>datasets/cwru.toml</summary>\n<pre>unit = 9.8\n</pre>"));
  EXPECT_THAT(html, HasSubstr("<summary>train.vae.toml</summary>\n<pre># &lt;b&gt;more&lt;/b&gt;\n"
                              "batch = 5\nwidth = 7.94\n</pre>"));
}

TEST_F(ReportPage, ShowsBuildAndMachine) {
  add_all();
  const std::string html = page();
  EXPECT_THAT(html, HasSubstr(text::markup_text(artefact::build_version())));
  EXPECT_THAT(html, HasSubstr(text::markup_text(artefact::build_libraries())));
  EXPECT_THAT(html, HasSubstr(text::markup_text(artefact::cpu_settings())));
}

TEST_F(ReportPage, WritesANarrowReportMd) {
  add_all();
  add_failed("cwru/seed2/vae/train.log", "train: diverged");
  const RequestedCells requested{
      .cells = {.methods = {"none vae"}, .ratios = {"100to1 10to1 2to1"}, .seeds = {"0 1 2"}}};
  const std::string markdown = text(requested);
  std::istringstream lines(markdown);
  for (std::string line; std::getline(lines, line);) EXPECT_THAT(line, SizeIs(Le(100U)));
  EXPECT_THAT(markdown, HasSubstr("4 of 12 cells are missing: 3 failed and 1 not started."));
  EXPECT_THAT(markdown, HasSubstr("(+27.5)."));
  EXPECT_THAT(markdown, HasSubstr("percent; without generated windows 62.5‡/61.8"));
  EXPECT_THAT(markdown, HasSubstr("| method |  10:1 |        2:1 |"));
  EXPECT_THAT(markdown, HasSubstr("| vae    | 75.0‡ | 90.0‡/91.2 |"));
}

TEST_F(ReportPage, WritesATableInReportMdWithoutGeneratedWindows) {
  add_baseline();
  EXPECT_THAT(text(), HasSubstr("| method |     100:1 |\n|--------|----------:|\n| none   | "));
}

/// Returns contents of a run of the paper's size, without files.
ReportContents large_run(std::size_t cells, std::size_t bytes_of_a_picture) {
  DatasetContents dataset{.name = "cwru"};
  dataset.grid = {
      .dataset = "cwru", .scored = {}, .combinations = {{"vae", "10to1"}}, .seeds = {0}};
  for (std::size_t i = 0; i < cells; ++i) {
    const auto seed = static_cast<std::int64_t>(i);
    dataset.results.diagnoses.push_back(
        {.method = "piae-dt-phase", .ratio = "10to1", .seed = seed});
    dataset.diagnosis_digests.emplace_back(64, 'a');
  }
  std::vector<FigureContents> figures;
  for (int i = 0; i < 60; ++i) {
    FigureContents figure{.name = "fig" + std::to_string(i), .title = "title"};
    figure.pictures.push_back(
        {.svg = {.file = figure.name + ".svg",
                 .address = "data:," + std::string(bytes_of_a_picture + i, 'x')},
         .csv = {.file = figure.name + ".csv", .address = "data:,1"}});
    figures.push_back(figure);
  }
  return {.datasets = {dataset}, .figures = {figures}};
}

TEST(ReportSize, IsAtMostFifteenMegabytesForThePapersRun) {
  const std::string html = report_page(large_run(2000, 200'000), {});
  EXPECT_LE(html.size(), most_bytes_of_report);
  EXPECT_THAT(html, Not(HasSubstr("too large to send")));
}

TEST(ReportSize, LinksTheLargestPicturesIfTheyDoNotFit) {
  const std::string html = report_page(large_run(2000, 300'000), {});
  EXPECT_LE(html.size(), most_bytes_of_report);
  EXPECT_GE(html.size(), most_bytes_of_report - 300'000);
  EXPECT_THAT(html, HasSubstr("too large to send; it is in <a href=\"./fig59.svg\">"));
  EXPECT_THAT(html, Not(HasSubstr("too large to send; it is in <a href=\"./fig0.svg\">")));
}

}  // namespace
}  // namespace piae::page
