#include "plan/plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "plan/goals.hpp"
#include "plan/small_run.hpp"
#include "text/lines.hpp"

namespace piae::plan {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

/// A finished small run with two tables of figures.
class RequestedFiles : public testing::Test {
 protected:
  RequestedFiles() {
    run_.run();
    run_.disk.files["results/t/real/figures/gains.csv"] = {.digest = "1"};
    run_.disk.files["results/t/real/figures/scatter.csv"] = {.digest = "2"};
  }

  /// Returns the names of the steps of a stretch.
  [[nodiscard]] std::vector<std::string> steps_of(const std::string& files, Stretch stretch) {
    const Plan& plan = run_.plan(files, stretch);
    std::vector<std::string> names;
    for (const StepId id : plan.requested())
      names.push_back(below_run(name_of(plan.graph().at(id))));
    return names;
  }

  SmallRun run_;
};

TEST_F(RequestedFiles, CanBePictures) {
  const std::string picture = "results/t/real/figures/gains.svg";
  EXPECT_THAT(steps_of(picture, Stretch::grid), IsEmpty());
  EXPECT_THAT(steps_of(picture, Stretch::numbers), ElementsAre("real/figures", "made/figures"));
  EXPECT_THAT(steps_of(picture, Stretch::pictures), ElementsAre("real/figures/gains.svg"));
  EXPECT_THAT(steps_of(picture, Stretch::pages), IsEmpty());
  EXPECT_THAT(steps_of(picture + " figures", Stretch::pictures),
              ElementsAre("real/figures/gains.svg", "real/figures/scatter.svg"));
  EXPECT_THAT(steps_of("results/t/real/figures/gains.csv", Stretch::pictures), IsEmpty());
}

TEST_F(RequestedFiles, CanBePages) {
  const std::string page = "results/t/report.html";
  EXPECT_THAT(steps_of(page, Stretch::grid), IsEmpty());
  EXPECT_THAT(steps_of(page, Stretch::pictures),
              ElementsAre("real/figures/gains.svg", "real/figures/scatter.svg"));
  EXPECT_THAT(steps_of(page, Stretch::pages), ElementsAre("report"));
}

TEST_F(RequestedFiles, AddTheStretchesTheyNeed) {
  const auto needed = [&](const std::string& goals) {
    std::vector<Stretch> needed;
    for (const Stretch stretch : stretches) {
      if (has_steps_in(stretch, run_.plan(goals, Stretch::grid).choice()))
        needed.push_back(stretch);
    }
    return needed;
  };
  EXPECT_THAT(needed("cells tables"), ElementsAre(Stretch::grid));
  EXPECT_THAT(needed("figures"), ElementsAre(Stretch::grid, Stretch::numbers, Stretch::pictures));
  EXPECT_THAT(needed("results/t/report.html"),
              ElementsAre(Stretch::grid, Stretch::numbers, Stretch::pictures, Stretch::pages));
}

TEST_F(RequestedFiles, CanHaveUnusualPaths) {
  EXPECT_THAT(steps_of("results/t//real/./records.h5", Stretch::grid), ElementsAre("real/ingest"));
}

TEST_F(RequestedFiles, AreRefusedIfNoStepMakesThem) {
  const std::vector<std::pair<std::string, Stretch>> unknown{
      {"results/t/real/other.h5", Stretch::grid},
      {"results/t/report.docx", Stretch::grid},
      {"results/t/real/figures/other.svg", Stretch::pictures}};
  for (const auto& [file, stretch] : unknown) {
    try {
      (void)run_.plan(file, stretch);
      ADD_FAILURE() << file;
    } catch (const Error& error) {
      EXPECT_EQ(error.what(), file +
                                  ": no step makes this file with the given DATASETS, METHODS, "
                                  "RATIOS, CLASSIFIERS and SEEDS; change these");
    }
  }
}

/// A run whose goals draw a picture of their table.
class RunWithPictures : public SmallRun {
 public:
  RunWithPictures() {
    set("[split]",
        "[transfer.both]\ndatasets = [\"real\", \"made\"]\nagainst = \"smote\"\n"
        "inputs = [\"smote=wdcnn\"]\nkind-inputs = [\"smote=wdcnn\"]\n[split]");
    set("[generate]", "[readings]\nbase = [\"batch=5\"]\nreadings = [\"depth=4\"]\n[generate]");
    set("epochs = 200", "epochs = 200\nbatch = 5\ndepth = 3\n[sweep]\npoints = [\"batch=1\"]");
    request.methods = "none smote piae-dt";
  }
};

TEST(Plan, NothingIsDueAfterAnyGoal) {
  for (const Goal& goal : goals()) {
    if (goal.add == nullptr) continue;
    RunWithPictures run;
    EXPECT_THAT(run.run(goal.name), Not(IsEmpty())) << goal.name;
    EXPECT_THAT(run.run(goal.name), IsEmpty()) << goal.name;
  }
}

TEST(Graph, RefusesTwoStepsOfOneName) {
  Graph graph;
  const Step table{.stage = "readings", .folder = "t", .log = "readings", .outputs = {"t/a.csv"}};
  EXPECT_EQ(graph.add(table), graph.add(table));
  EXPECT_THROW(
      graph.add({.stage = "draw", .folder = "t", .log = "readings", .outputs = {"t/a.svg"}}),
      std::logic_error);
}

TEST(Goals, AFolderIsNotAFileOfAGoal) {
  for (const char* folder : {"results/t/", "results/", "/", ""}) {
    EXPECT_EQ(goal_of_file(folder).name, "all") << folder;
  }
}

/// Returns the words of lines `name := ...` and `name += ...` of the Makefile.
std::vector<std::string> words_in_makefile(const std::string& name) {
  std::vector<std::string> all;
  for (const std::string& line : text::read_lines(PIAE_SOURCE "/Makefile")) {
    const std::vector<std::string> words = words_in(line);
    if (words.size() > 2 && words[0] == name) all.insert(all.end(), words.begin() + 2, words.end());
  }
  return all;
}

TEST(Goals, AreThoseOfTheMakefile) {
  EXPECT_THAT(words_in_makefile("grid_goals"), testing::UnorderedElementsAreArray(goal_names()));
}

// make installs gnuplot for the goals that draw.
TEST(Goals, ThatDrawAreThoseOfTheMakefile) {
  const std::vector<std::string> drawing = words_in_makefile("drawing");
  for (const Goal& goal : goals()) {
    RunWithPictures run;
    const std::vector<Step>& steps = run.plan(goal.name).graph().steps();
    const bool draws = goal.draws || std::ranges::count(steps, "draw", &Step::stage) > 0;
    EXPECT_EQ(std::ranges::count(drawing, goal.name), draws ? 1 : 0) << goal.name;
  }
}

}  // namespace
}  // namespace piae::plan
