#include <gmock/gmock.h>

#include "report/paper_methods.hpp"
#include "report/paper_reference.hpp"

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

TEST(Groups, TakeAnyOtherMethodIntoTheComparisonInTheOrderAskedFor) {
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

TEST(References, OfThePapersOwnDatasets) {
  const PaperReference cwru("cwru");
  EXPECT_EQ(cwru.table(&PaperDataset::baseline_table), " (the paper's Table 6)");
  EXPECT_EQ(cwru.table(&PaperDataset::methods_table), " (the paper's Table 8)");
  EXPECT_EQ(cwru.table(&PaperDataset::ablation_table), " (the paper's Table 10)");
  EXPECT_EQ(cwru.figure(&PaperDataset::methods_quality_figure), " (the paper's Fig. 13)");
  EXPECT_EQ(cwru.figure(&PaperDataset::ablation_quality_figure), " (the paper's Fig. 16)");
  EXPECT_EQ(cwru.figure(15), " (the paper's Fig. 15)");
  EXPECT_EQ(cwru.none(), "");
  EXPECT_EQ(cwru.label(), "paper");
  const PaperReference hfhp("hfhp");
  EXPECT_EQ(hfhp.table(&PaperDataset::baseline_table), " (the paper's Table 7)");
  EXPECT_EQ(hfhp.table(&PaperDataset::methods_table), " (the paper's Table 9)");
  EXPECT_EQ(hfhp.table(&PaperDataset::ablation_table), " (the paper's Table 11)");
  EXPECT_EQ(hfhp.figure(&PaperDataset::methods_quality_figure), " (the paper's Fig. 14)");
  EXPECT_EQ(hfhp.figure(&PaperDataset::ablation_quality_figure), " (the paper's Fig. 17)");
  EXPECT_EQ(hfhp.label(), "paper");
}

TEST(References, OfAStandInSaySo) {
  const PaperReference hit_sm("hit-sm");
  EXPECT_EQ(hit_sm.table(&PaperDataset::methods_table),
            " (in the place of the paper's Table 9; hit-sm stands in for HFHP)");
  EXPECT_EQ(hit_sm.figure(18), " (in the place of the paper's Fig. 18; hit-sm stands in for HFHP)");
  EXPECT_EQ(hit_sm.none(), " (hit-sm stands in for HFHP)");
  EXPECT_EQ(hit_sm.label(), "paper, HFHP");
  EXPECT_FALSE(hit_sm.beside()->own);
  EXPECT_FALSE(PaperReference("cwru-as-published").beside()->own);
}

TEST(References, AreNotMadeForOtherDatasets) {
  const PaperReference simulated("simulated");
  EXPECT_EQ(simulated.beside(), std::nullopt);
  EXPECT_EQ(simulated.table(&PaperDataset::methods_table), "");
  EXPECT_EQ(simulated.figure(&PaperDataset::methods_quality_figure), "");
  EXPECT_EQ(simulated.figure(15), "");
  EXPECT_EQ(simulated.none(), "");
}

}  // namespace
}  // namespace piae::report
