#include "report/paper.hpp"

#include <gmock/gmock.h>

namespace piae::report {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Groups, AreThePapersComparisonAndItsAblation) {
  const auto groups = method_groups({"dynamics", "smote", "vae", "wgan-gp", "piae-dt", "ae",
                                     "physics", "piae-dt-cnn", "piae-dt-rnn"});
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_THAT(groups[0].methods, ElementsAre("dynamics", "smote", "vae", "wgan-gp", "piae-dt"));
  EXPECT_FALSE(groups[0].are_models);
  EXPECT_THAT(groups[1].methods,
              ElementsAre("piae-dt", "ae", "physics", "piae-dt-cnn", "piae-dt-rnn"));
  EXPECT_TRUE(groups[1].are_models);
}

TEST(Groups, IncludeTheAblationsOfTheOutlook) {
  const auto groups = method_groups({"smote", "piae-dt", "ae", "piae-dt-tcn"});
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_THAT(groups[0].methods, ElementsAre("smote", "piae-dt"));
  EXPECT_THAT(groups[1].methods, ElementsAre("piae-dt", "ae", "piae-dt-tcn"));
  EXPECT_EQ(method_groups({"piae-dt", "piae-dt-transformer"}).size(), 2U);
}

TEST(Groups, AddOtherMethodsInTheRequestedOrder) {
  const auto groups = method_groups({"shift", "piae-dt", "toy", "dynamics"});
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_THAT(groups[0].methods, ElementsAre("shift", "piae-dt", "toy", "dynamics"));
}

TEST(Groups, AreNeverEmpty) {
  EXPECT_THAT(method_groups({}), IsEmpty());
  const auto groups = method_groups({"physics", "ae"});
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].key, "ablation");
  EXPECT_THAT(groups[0].methods, ElementsAre("physics", "ae"));
}

/// Returns the words that a place adds to a section: after its title and before its note.
std::string text_of(const Place& place) {
  const Section section = place.of({"key", "T", "N", text::Table({}, 0)});
  return section.title + "|" + section.note;
}

TEST(References, NameThePapersTablesForItsDatasets) {
  const PaperReference cwru("cwru");
  EXPECT_EQ(text_of(cwru.table(&PaperDataset::baseline_table)), "T (the paper's Table 6)|N");
  EXPECT_EQ(text_of(cwru.table(&PaperDataset::methods_table)), "T (the paper's Table 8)|N");
  EXPECT_EQ(text_of(cwru.table(&PaperDataset::ablation_table)), "T (the paper's Table 10)|N");
  EXPECT_EQ(text_of(cwru.figure(&PaperDataset::methods_quality_figure)),
            "T (the paper's Fig. 13)|N");
  EXPECT_EQ(text_of(cwru.figure(&PaperDataset::ablation_quality_figure)),
            "T (the paper's Fig. 16)|N");
  EXPECT_EQ(text_of(cwru.figure(15)), "T (the paper's Fig. 15)|N");
  EXPECT_EQ(text_of(cwru.none()), "T|N");
  EXPECT_EQ(cwru.label(), "paper");
  const PaperReference hfhp("hfhp");
  EXPECT_EQ(text_of(hfhp.table(&PaperDataset::baseline_table)), "T (the paper's Table 7)|N");
  EXPECT_EQ(text_of(hfhp.table(&PaperDataset::methods_table)), "T (the paper's Table 9)|N");
  EXPECT_EQ(text_of(hfhp.table(&PaperDataset::ablation_table)), "T (the paper's Table 11)|N");
  EXPECT_EQ(text_of(hfhp.figure(&PaperDataset::methods_quality_figure)),
            "T (the paper's Fig. 14)|N");
  EXPECT_EQ(text_of(hfhp.figure(&PaperDataset::ablation_quality_figure)),
            "T (the paper's Fig. 17)|N");
  EXPECT_EQ(hfhp.label(), "paper");
}

// A title is one line of at most 100 characters, so longer words go into the note.
TEST(References, NameAStandIn) {
  const PaperReference hit_sm("hit-sm");
  EXPECT_EQ(text_of(hit_sm.table(&PaperDataset::methods_table)),
            "T|Replaces the paper's Table 9; hit-sm stands in for HFHP. N");
  EXPECT_EQ(text_of(hit_sm.figure(18)),
            "T|Replaces the paper's Fig. 18; hit-sm stands in for HFHP. N");
  EXPECT_EQ(text_of(hit_sm.none()), "T|hit-sm stands in for HFHP. N");
  EXPECT_EQ(hit_sm.none().of({"key", "T", "", text::Table({}, 0)}).note,
            "hit-sm stands in for HFHP.");
  EXPECT_EQ(hit_sm.label(), "paper, HFHP");
  EXPECT_FALSE(hit_sm.counterpart()->own);
  EXPECT_FALSE(PaperReference("cwru-as-published").counterpart()->own);
}

TEST(References, AreEmptyForOtherDatasets) {
  const PaperReference simulated("simulated");
  EXPECT_EQ(simulated.counterpart(), std::nullopt);
  EXPECT_EQ(text_of(simulated.table(&PaperDataset::methods_table)), "T|N");
  EXPECT_EQ(text_of(simulated.figure(&PaperDataset::methods_quality_figure)), "T|N");
  EXPECT_EQ(text_of(simulated.figure(15)), "T|N");
  EXPECT_EQ(text_of(simulated.none()), "T|N");
}

}  // namespace
}  // namespace piae::report
