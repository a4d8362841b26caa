#include "plan/default_lists.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <utility>

#include "plan/small_run.hpp"
#include "support/errors.hpp"

namespace piae::plan {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsSupersetOf;
using testing::Not;
using testing::SizeIs;
using testing::UnorderedElementsAre;

class DefaultLists : public testing::Test {
 protected:
  [[nodiscard]] Lists of(const std::vector<std::string>& goals) const {
    return default_lists(read_experiment(run_.pipeline.path()), goals);
  }

  SmallRun run_;
};

TEST_F(DefaultLists, AreThePapersGridAndOurRecommendations) {
  const Lists lists = of({"all"});
  EXPECT_THAT(lists.datasets, ElementsAre("cwru"));
  EXPECT_THAT(lists.methods, SizeIs(12));
  EXPECT_THAT(methods_of_paper(), SizeIs(10));
  EXPECT_EQ(lists.methods.front(), "none");
  EXPECT_THAT(lists.ratios,
              ElementsAre("100to1", "50to1", "25to1", "10to1", "5to1", "2to1", "1to1"));
  EXPECT_THAT(lists.classifiers, ElementsAre("wdcnn"));
  EXPECT_THAT(lists.seeds, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8, 9));
}

TEST_F(DefaultLists, UseTheSeedsOfChoicesForReadings) {
  const Lists lists = of({"readings"});
  EXPECT_THAT(lists.datasets, ElementsAre("cwru", "hit-sm", "simulated"));
  EXPECT_THAT(lists.methods, ElementsAre("piae-dt"));
  EXPECT_THAT(lists.seeds, ElementsAre(100, 101, 102, 103, 104));
}

TEST_F(DefaultLists, AreSimulatedForAnIdentification) {
  EXPECT_THAT(of({"identify"}).datasets, ElementsAre("simulated"));
  EXPECT_THAT(of({"identify"}).methods, ElementsAre("piae-dt", "piae-dt-phase"));
  EXPECT_THAT(of({"identify", "all"}).datasets, ElementsAre("cwru"));
}

TEST_F(DefaultLists, AreWhatWorksWithoutKnownFaultsForVerdicts) {
  const Lists lists = of({"verdicts"});
  EXPECT_THAT(lists.datasets, ElementsAre("cwru-blind"));
  EXPECT_THAT(lists.methods, ElementsAre("none", "piae-dt-zero", "healthy-plus-impulses"));
  EXPECT_THAT(lists.ratios, ElementsAre("100to1", "1to1"));
  EXPECT_THAT(lists.classifiers, ElementsAre("nearest", "envelope-rule", "exclusion-rule",
                                             "symptom-net", "any-bearing"));
  EXPECT_THAT(lists.seeds, ElementsAre(0));
}

TEST_F(DefaultLists, CoverTheGroupsForATransfer) {
  EXPECT_ERROR((void)of({"transfer"}), Exit::usage, "does not name a group of data sets");
  run_.set("[diagnose]",
           "[transfer.both]\ndatasets = [\"real\", \"made\"]\nagainst = \"smote\"\n"
           "inputs = [\"smote=wdcnn-spectra\", \"none=wdcnn\"]\n[diagnose]");
  const Lists lists = of({"transfer"});
  EXPECT_THAT(lists.datasets, ElementsAre("made", "real"));
  EXPECT_THAT(lists.methods, ElementsAre("none", "smote"));
  EXPECT_THAT(lists.ratios, ElementsAre("100to1", "1to1"));
  EXPECT_THAT(lists.classifiers,
              ElementsAre("wdcnn", "wdcnn-spectra", "nearest", "nearest-orders"));
}

class Rivals : public testing::Test {
 protected:
  /// Returns the lists for these data sets of the project.
  static Lists of(const std::vector<std::string>& datasets,
                  const std::vector<std::string>& goals = {"all"}) {
    const Experiment own = read_experiment(std::filesystem::path(PIAE_SOURCE) / "pipeline");
    Lists lists = default_lists(own, goals);
    lists.datasets = datasets;
    take_rivals(own, goals, lists);
    return lists;
  }
};

TEST_F(Rivals, AreComparedWhereFaultsAreKnownInAnotherCondition) {
  const Lists lists = of({"hit-sm-1200to900"});
  EXPECT_THAT(lists.methods,
              IsSupersetOf({"none", "strike-twin", "smote", "mixup", "aligned-mixup", "spectral",
                            "adasyn", "borderline-smote", "resample", "randomise", "oracle"}));
  EXPECT_THAT(lists.classifiers,
              UnorderedElementsAre("nearest", "nearest-orders", "wdcnn-orders", "prototypes"));
  for (const char* slow : {"ddpm", "ddpm-healthy-angle", "flow-angle"}) {
    EXPECT_THAT(lists.methods, Not(Contains(slow)));
    EXPECT_THAT(of({"hit-sm-1200to900"}, {"transfer"}).methods, Contains(slow));
  }
  EXPECT_THAT(lists.ratios, ElementsAre("100to1", "1to1"));
  EXPECT_THAT(of({"cwru-sizes-7"}).classifiers, IsSupersetOf({"wdcnn", "nearest-orders"}));
}

TEST_F(Rivals, AreThoseOfTheGroupsOfTheDataSets) {
  EXPECT_THAT(of({"uestc-800to1000"}).methods, Not(Contains("piae-dt")));
  EXPECT_THAT(of({"uestc-800to1000", "cwru-sizes-7"}).methods, Contains("piae-dt"));
  // It is in no group, so it has the rivals of all.
  EXPECT_THAT(of({"simulated-slower"}).classifiers, IsSupersetOf({"prototypes", "wdcnn-envelope"}));
}

TEST_F(Rivals, AreNotComparedElsewhere) {
  for (const auto& [dataset, goal] : std::vector<std::pair<std::string, std::string>>{
           {"cwru", "all"}, {"hit-sm-types-1200to900", "all"}, {"hit-sm-1200to900", "sweep"}}) {
    EXPECT_THAT(of({dataset}, {goal}).methods, SizeIs(12)) << dataset;
    EXPECT_THAT(of({dataset}, {goal}).classifiers, ElementsAre("wdcnn")) << dataset;
  }
  EXPECT_THAT(of({"cwru", "hit-sm-1200to900"}).methods, SizeIs(12));
}

}  // namespace
}  // namespace piae::plan
