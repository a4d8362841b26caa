#include <gmock/gmock.h>

#include <filesystem>
#include <string>
#include <vector>

#include "run/held.hpp"
#include "run/started.hpp"
#include "support/errors.hpp"
#include "support/stored_run.hpp"

/// Tests the classifier as an axis of the grid.
namespace piae::run {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Names each cell of a grid without the seed: "vae 10to1 nearest".
std::vector<std::string> names_of(const Grid& grid) {
  std::vector<std::string> names;
  for (const Combination& cell : grid.combinations) {
    names.push_back(cell.method + " " + cell.ratio + " " + cell.classifier);
  }
  return names;
}

GridOptions requested_by(const std::vector<std::string>& classifiers) {
  return {.dataset = "cwru",
          .methods = {"none vae"},
          .ratios = {"100to1 10to1"},
          .seeds = {"0 1"},
          .classifiers = classifiers};
}

TEST(GridOfClassifiers, HasOnlyThePapersByDefault) {
  EXPECT_THAT(names_of(resolve(requested_by({}))),
              ElementsAre("none 100to1 wdcnn", "vae 10to1 wdcnn"));
}

TEST(GridOfClassifiers, AlwaysHasTheBaselineByNearest) {
  EXPECT_THAT(names_of(resolve(requested_by({"wdcnn"}))),
              ElementsAre("none 100to1 wdcnn", "vae 10to1 wdcnn", "none 100to1 nearest"));
  EXPECT_THAT(names_of(resolve(requested_by({"nearest wdcnn-spectra"}))),
              ElementsAre("none 100to1 nearest", "vae 10to1 nearest", "none 100to1 wdcnn-spectra",
                          "vae 10to1 wdcnn-spectra"));
  GridOptions generated = requested_by({"wdcnn"});
  generated.methods = {"vae"};
  EXPECT_THAT(names_of(resolve(generated)), ElementsAre("vae 10to1 wdcnn"));
}

TEST(GridOfClassifiers, RefusesUnknownNames) {
  EXPECT_ERROR(resolve(requested_by({"svm"})), Exit::usage, "unknown classifier 'svm'");
  EXPECT_ERROR(resolve(requested_by({"wdcnn", "wdcnn"})), Exit::usage,
               "--classifiers names wdcnn twice");
}

TEST(GridOfClassifiers, MayHaveOneClassifier) {
  EXPECT_THAT(names_of(of_classifier(resolve(requested_by({"wdcnn"})), "nearest")),
              ElementsAre("none 100to1 nearest"));
}

class CellsOfClassifiers : public StoredRun {
 protected:
  [[nodiscard]] Collected collected(const Grid& requested,
                                    Classifiers which = Classifiers::all) const {
    return collect_held_diagnoses(layout_, requested, Held(layout_), which);
  }
  void add_reference() const {
    for (const int seed : {0, 1}) add(by("nearest", diagnosis("none", "100to1", 0, seed, 19)));
  }
};

TEST_F(CellsOfClassifiers, AreInAFolderForEachClassifier) {
  EXPECT_EQ(layout_.diagnosis("vae", "10to1", 3),
            layout_.folder() / "seed3/vae/10to1/wdcnn/diagnosis.h5");
  EXPECT_EQ(layout_.diagnosis("vae", "10to1", 3, "nearest"),
            layout_.folder() / "seed3/vae/10to1/nearest/diagnosis.h5");
}

TEST_F(CellsOfClassifiers, AreFoundWithoutARequest) {
  add_all();
  add_reference();
  add(by("wdcnn-spectrum", diagnosis("vae", "2to1", 145, 1, 20)));
  const Collected all = collected(grid("none", "100to1", "0"));
  EXPECT_THAT(names_of(all.grid),
              ElementsAre("none 100to1 wdcnn", "vae 10to1 wdcnn", "vae 2to1 wdcnn",
                          "vae 2to1 wdcnn-spectrum", "none 100to1 nearest"));
  EXPECT_EQ(all.results.diagnoses.size(), 9U);
  EXPECT_THAT(all.results.problems, IsEmpty());
  EXPECT_THAT(names_of(collected(grid("none", "100to1", "0"), Classifiers::papers).grid),
              ElementsAre("none 100to1 wdcnn", "vae 10to1 wdcnn", "vae 2to1 wdcnn"));
  EXPECT_EQ(names_of(held_grid(layout_, grid_, Held(layout_))), names_of(all.grid));
}

TEST_F(CellsOfClassifiers, AreNamedIfMissing) {
  add_all();
  const Results results = collected(resolve(requested_by({"wdcnn"}))).results;
  EXPECT_THAT(results.problems,
              ElementsAre(HasSubstr("method none by nearest, ratio 100to1, seed 0: "),
                          HasSubstr("method none by nearest, ratio 100to1, seed 1: ")));
}

TEST_F(CellsOfClassifiers, AreRefusedInTheFolderOfAnotherClassifier) {
  add_all();
  std::filesystem::create_directories(
      layout_.diagnosis("vae", "10to1", 0, "nearest").parent_path());
  std::filesystem::copy_file(layout_.diagnosis("vae", "10to1", 0),
                             layout_.diagnosis("vae", "10to1", 0, "nearest"));
  EXPECT_THAT(collected(grid_).results.problems,
              ElementsAre(HasSubstr("the classifier is wdcnn, here it must be nearest")));
}

TEST_F(CellsOfClassifiers, AreMissingBecauseOfTheStepWithoutAResult) {
  const auto cell = layout_.diagnosis("vae", "10to1", 0, "nearest");
  EXPECT_EQ(Layout::unfinished_log(cell), std::nullopt);
  folder_.write("run/cwru/seed0/vae/10to1/nearest/diagnose.log", "");
  EXPECT_EQ(Layout::unfinished_log(cell), cell.parent_path() / "diagnose.log");
  folder_.write("run/cwru/seed0/vae/train.log", "");
  EXPECT_EQ(Layout::unfinished_log(cell), layout_.folder() / "seed0/vae/train.log");
}

TEST_F(CellsOfClassifiers, DefaultToTheStartedOnes) {
  add_all();
  const GridOptions nothing_requested{
      .dataset = dataset_, .methods = {}, .ratios = {}, .seeds = {}};
  EXPECT_EQ(names_of(Started(layout_).resolve(nothing_requested)).size(), 3U);
  // The baseline's own cell does not add such cells to other methods.
  add_reference();
  EXPECT_THAT(
      names_of(Started(layout_).resolve(nothing_requested)),
      ElementsAre("none 100to1 wdcnn", "vae 10to1 wdcnn", "vae 2to1 wdcnn", "none 100to1 nearest"));
  add(by("wdcnn-spectrum", diagnosis("vae", "2to1", 145, 1, 20)));
  EXPECT_THAT(names_of(Started(layout_).resolve(nothing_requested)),
              ElementsAre("none 100to1 wdcnn", "vae 10to1 wdcnn", "vae 2to1 wdcnn",
                          "none 100to1 wdcnn-spectrum", "vae 10to1 wdcnn-spectrum",
                          "vae 2to1 wdcnn-spectrum", "none 100to1 nearest"));
}

TEST_F(CellsOfClassifiers, AreNotStartedIfOnlyTheClassifierIsKept) {
  add_all();
  folder_.write("run/cwru/seed0/vae/2to1/wdcnn-spectrum/classifier.h5", "");
  const GridOptions nothing_requested{
      .dataset = dataset_, .methods = {}, .ratios = {}, .seeds = {}};
  EXPECT_EQ(names_of(Started(layout_).resolve(nothing_requested)).size(), 3U);
  folder_.write("run/cwru/seed0/vae/2to1/wdcnn-spectrum/diagnose.log", "");
  EXPECT_EQ(names_of(Started(layout_).resolve(nothing_requested)).size(), 7U);
}

/// Without known faults a run may have only rules and symptom-net.
TEST_F(CellsOfClassifiers, MayBeStartedWithoutThePapersClassifier) {
  add(by("symptom-net", diagnosis("vae", "2to1", 145, 1, 20)));
  const GridOptions nothing_requested{
      .dataset = dataset_, .methods = {}, .ratios = {}, .seeds = {}};
  EXPECT_THAT(names_of(Started(layout_).resolve(nothing_requested)),
              ElementsAre("vae 2to1 symptom-net"));
  folder_.write("run/cwru/seed1/vae/2to1/wdcnn/diagnose.log", "");
  EXPECT_THAT(names_of(Started(layout_).resolve(nothing_requested)),
              ElementsAre("vae 2to1 wdcnn", "vae 2to1 symptom-net"));
}

}  // namespace
}  // namespace piae::run
