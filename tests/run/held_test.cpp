#include "run/held.hpp"

#include "support/stored_run.hpp"

namespace piae::run {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using Strings = std::vector<std::string>;

class HeldCells : public StoredRun {
 protected:
  [[nodiscard]] Collected collected(const Grid& requested, const Strings& leave_out = {}) const {
    return collect_held(layout_, requested, Held(layout_, leave_out));
  }
  /// Names each diagnosis that was read: "vae 2to1 0".
  [[nodiscard]] static Strings names(const Results& results) {
    Strings names;
    for (const Diagnosis& cell : results.diagnoses) {
      names.push_back(cell.method + " " + cell.ratio + " " + std::to_string(cell.seed));
    }
    return names;
  }
  [[nodiscard]] static Strings names(const Grid& grid) {
    Strings names;
    for (const Combination& cell : grid.combinations)
      names.push_back(cell.method + " " + cell.ratio);
    return names;
  }
  const Grid part_ = grid("none", "100to1", "1");
};

TEST_F(HeldCells, IncludeCellsBeyondTheRequest) {
  add_all();
  const Collected all = collected(grid_);
  EXPECT_THAT(names(all.grid), ElementsAre("none 100to1", "vae 10to1", "vae 2to1"));
  EXPECT_THAT(all.grid.scored, ElementsAre("vae"));
  EXPECT_THAT(all.grid.seeds, ElementsAre(0, 1));
  EXPECT_EQ(all.results.diagnoses.size(), 6U);
  const Collected more = collected(part_);
  EXPECT_EQ(names(more.grid), names(all.grid));
  EXPECT_EQ(names(more.results), names(all.results));
  EXPECT_EQ(more.grid.seeds, all.grid.seeds);
  EXPECT_EQ(more.results.qualities.size(), 2U);
  EXPECT_THAT(more.results.problems, IsEmpty());
}

TEST_F(HeldCells, FollowTheOrderOfTheCatalogue) {
  add_all();
  add_method("smote");
  EXPECT_THAT(names(collected(grid("vae smote none", "2to1 10to1 100to1")).grid),
              ElementsAre("none 100to1", "smote 10to1", "smote 2to1", "vae 10to1", "vae 2to1"));
}

TEST_F(HeldCells, MustExistIfRequested) {
  add_all();
  std::filesystem::remove(layout_.diagnosis("vae", "2to1", 1));
  std::filesystem::remove(layout_.score("vae", 0));
  EXPECT_THAT(collected(grid_).results.problems,
              ElementsAre(HasSubstr("method vae, ratio 2to1, seed 1: "),
                          HasSubstr("method vae, seed 0: ")));
  const Collected of_part = collected(part_);
  EXPECT_THAT(of_part.results.problems, IsEmpty());
  EXPECT_THAT(names(of_part.results), ElementsAre("none 100to1 0", "none 100to1 1", "vae 10to1 0",
                                                  "vae 10to1 1", "vae 2to1 0"));
  EXPECT_EQ(of_part.results.qualities.size(), 1U);
}

TEST_F(HeldCells, IncludeUnknownMethodsOnlyIfRequested) {
  add_all();
  add_method("toy");
  EXPECT_EQ(collected(grid_).results.diagnoses.size(), 6U);
  EXPECT_EQ(collected(grid("toy", "10to1 2to1")).results.diagnoses.size(), 10U);
}

TEST_F(HeldCells, AreRefusedIfDamagedEvenWithoutARequest) {
  add_all();
  std::filesystem::resize_file(layout_.diagnosis("vae", "2to1", 0), 1000);
  const Results results = collected(part_).results;
  EXPECT_THAT(results.problems, ElementsAre(HasSubstr("method vae, ratio 2to1, seed 0: ")));
  EXPECT_EQ(results.exit, Exit::bad_input);
}

TEST_F(HeldCells, ListTheirArtefactsInTheOrderOfTheResults) {
  add_all();
  add_method("smote");
  std::filesystem::copy_file(layout_.diagnosis("vae", "2to1", 1),
                             layout_.diagnosis("vae", "2to1", 0),
                             std::filesystem::copy_options::overwrite_existing);
  Strings shown;
  const SeenCell see = [&](const artefact::Reader& cell) {
    const std::string ratio = cell.kind() == "score" ? "" : cell.text("/", "ratio") + " ";
    shown.push_back(cell.text("/", "method") + " " + ratio +
                    std::to_string(cell.integer("/", "seed")));
    if (shown.back() == "smote 2to1 1") cell.refuse("/", "is not liked");
  };
  const Results results = collect_held(layout_, part_, Held(layout_), see).results;
  EXPECT_THAT(results.problems,
              ElementsAre(HasSubstr("smote, ratio 2to1, seed 1: "), HasSubstr("the seed is 1")));
  EXPECT_THAT(results.problems, Contains(HasSubstr("diagnosis.h5: / is not liked")));
  Strings wanted = names(results);
  for (const scoring::QualityRecord& cell : results.qualities) {
    wanted.push_back(cell.method + " " + std::to_string(cell.seed));
  }
  std::erase(shown, "smote 2to1 1");
  EXPECT_EQ(shown, wanted);
}

TEST_F(HeldCells, AreLeftOutByNameIfOutOfDate) {
  add_all();
  const auto cell = [](const std::string& method, const std::string& ratio, std::int64_t seed) {
    return AllOf(Field(&CellName::method, method), Field(&CellName::ratio, ratio),
                 Field(&CellName::seed, seed));
  };
  const Results folder = collected(part_, {"seed0/vae"}).results;
  EXPECT_THAT(names(folder),
              ElementsAre("none 100to1 0", "none 100to1 1", "vae 10to1 1", "vae 2to1 1"));
  EXPECT_THAT(folder.left_out,
              ElementsAre(cell("vae", "10to1", 0), cell("vae", "2to1", 0), cell("vae", "", 0)));
  const Results file = collected(part_, {"seed1/vae/2to1/wdcnn/diagnosis.h5"}).results;
  EXPECT_THAT(file.left_out, ElementsAre(cell("vae", "2to1", 1)));
  // A prefix of a name does not match.
  EXPECT_THAT(collected(part_, {"seed1/va", "seed"}).results.left_out, IsEmpty());
}

/// A report requests everything that the run has started.
TEST_F(HeldCells, AreLeftOutEvenIfRequested) {
  add_all();
  const Results results = collected(grid_, {"seed0", "seed1/vae"}).results;
  EXPECT_THAT(names(results), ElementsAre("none 100to1 1"));
  EXPECT_THAT(results.problems, IsEmpty());
  EXPECT_EQ(results.left_out.size(), 7U);  // none and twice vae; twice vae; two scores
}

TEST_F(HeldCells, LeaveNoTraceOfSeedsThatAreLeftOut) {
  add_all();
  EXPECT_THAT(collected(part_, {"seed0"}).grid.seeds, ElementsAre(1));
}

TEST_F(HeldCells, CountOnlyIfAnotherRunHasThem) {
  add_all();
  const Layout other(folder_.path() / "other", "cwru");
  std::filesystem::copy(folder_.path() / "run", folder_.path() / "other",
                        std::filesystem::copy_options::recursive);
  std::filesystem::remove(other.diagnosis("vae", "10to1", 0));
  const Held both(layout_, other, {});
  EXPECT_FALSE(both.has(layout_.diagnosis("vae", "10to1", 0)));
  EXPECT_TRUE(both.has(layout_.diagnosis("vae", "10to1", 1)));
  EXPECT_TRUE(Held(layout_).has(layout_.diagnosis("vae", "10to1", 0)));
}

TEST_F(HeldCells, AreEmptyWithoutARun) {
  EXPECT_THAT(Held(layout_).seeds(), IsEmpty());
  EXPECT_THAT(collected(part_).results.problems,
              ElementsAre(HasSubstr("none, ratio 100to1, seed 1")));
}

class HeldModels : public StoredRun {
 protected:
  void touch(const std::filesystem::path& file) const {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << "x";
  }
  [[nodiscard]] Strings models(const Grid& requested) const {
    Strings names;
    for (const CellName& model : held_models(layout_, requested, Held(layout_))) {
      names.push_back(model.method + " " + std::to_string(model.seed));
    }
    return names;
  }
};

TEST_F(HeldModels, IncludeRequestedModelsAndModelsThatInfer) {
  for (const char* method : {"piae-dt", "piae-dt-phase", "smote"}) touch(layout_.model(method, 0));
  touch(layout_.model("piae-dt", 1));
  touch(layout_.model("piae-dt", 2));
  for (const int seed : {0, 1}) touch(layout_.real_windows(seed));
  EXPECT_THAT(models(grid("piae-dt-phase", "1to1", "0")),
              ElementsAre("piae-dt 0", "piae-dt 1", "piae-dt-phase 0"));
  EXPECT_THAT(models(grid("piae-dt", "1to1", "2 3")),
              ElementsAre("piae-dt 0", "piae-dt 1", "piae-dt 2", "piae-dt 3", "piae-dt-phase 0"));
}

}  // namespace
}  // namespace piae::run
