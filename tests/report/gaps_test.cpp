#include "report/gaps.hpp"

#include <gmock/gmock.h>

namespace piae::report {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

TEST(Seeds, AreListedInRanges) {
  EXPECT_EQ(seed_list({3}), "3");
  EXPECT_EQ(seed_list({0, 1}), "0, 1");
  EXPECT_EQ(seed_list({0, 1, 2}), "0 to 2");
  EXPECT_EQ(seed_list({0, 1, 2, 5, 8, 9, 100}), "0 to 2, 5, 8, 9, 100");
}

/// A run of `none`, smote and vae at two ratios, with the fields that paragraphs on gaps read.
class Gaps : public testing::Test {
 protected:
  void add(const std::string& method, const std::string& ratio,
           const std::vector<std::int64_t>& seeds) {
    for (const std::int64_t seed : seeds) {
      run::Diagnosis& cell = results_.diagnoses.emplace_back();
      cell.method = method;
      cell.ratio = ratio;
      cell.seed = seed;
    }
  }
  void add_scores(const std::string& method, const std::vector<std::int64_t>& seeds) {
    for (const std::int64_t seed : seeds) {
      scoring::QualityRecord& record = results_.qualities.emplace_back();
      record.method = method;
      record.seed = seed;
    }
  }
  void add_all_but_vae() {
    add("none", "100to1", {0, 1, 2});
    add("smote", "10to1", {0, 1, 2});
    add("smote", "1to1", {0, 1, 2});
    add_scores("smote", {0, 1, 2});
  }
  [[nodiscard]] std::vector<std::string> paragraphs() const {
    return gap_paragraphs(grid_, results_);
  }

  const run::Grid grid_ =
      resolve(run::GridOptions{"cwru", {"none smote vae"}, {"100to1 10to1 1to1"}, {"0 1 2"}});
  run::Results results_;
};

TEST_F(Gaps, AreNotMentionedIfThereAreNone) {
  add_all_but_vae();
  add("vae", "10to1", {0, 1, 2});
  add("vae", "1to1", {0, 1, 2});
  add_scores("vae", {0, 1, 2});
  EXPECT_THAT(paragraphs(), IsEmpty());
  EXPECT_EQ(left_out_line(results_), "");
}

TEST_F(Gaps, NameTheSeedsOfAMethodWithFewer) {
  add_all_but_vae();
  add("vae", "10to1", {0, 2});
  add("vae", "1to1", {0, 2});
  add_scores("vae", {0, 2});
  EXPECT_THAT(paragraphs(), ElementsAre(HasSubstr("these have only: vae: seeds 0, 2. Each")));
}

TEST_F(Gaps, NameTheRatiosOfAMethodWithFewer) {
  add_all_but_vae();
  add("vae", "1to1", {0, 1, 2});
  add_scores("vae", {0, 1, 2});
  EXPECT_THAT(paragraphs(), ElementsAre(HasSubstr("vae: 1:1 of seeds 0 to 2. Each")));
  add("vae", "10to1", {1});
  EXPECT_THAT(paragraphs(),
              ElementsAre(HasSubstr("vae: 10:1 of seed 1, and 1:1 of seeds 0 to 2. Each")));
}

TEST_F(Gaps, GroupMethodsWithTheSameGaps) {
  add("none", "100to1", {0, 1, 2});
  for (const char* method : {"smote", "vae"}) {
    add(method, "1to1", {1});
    add(method, "10to1", {1});
    add_scores(method, {1});
  }
  EXPECT_THAT(paragraphs(), ElementsAre(HasSubstr("smote, vae: seed 1. Each")));
}

TEST_F(Gaps, NameMissingScores) {
  add_all_but_vae();
  add("vae", "10to1", {0, 1, 2});
  add("vae", "1to1", {0, 1, 2});
  add_scores("vae", {0, 1});
  EXPECT_THAT(paragraphs(),
              ElementsAre("The quality of windows is known only for vae: seeds 0, 1."));
}

TEST_F(Gaps, NameLeftOutCells) {
  add_all_but_vae();
  results_.left_out = {
      {"smote", "10to1", 3}, {"smote", "1to1", 3}, {"vae", "", 3}, {"vae", "1to1", 4}};
  EXPECT_EQ(left_out_line(results_),
            "left out, because they are damaged or were made with other settings or inputs: cells "
            "of smote: "
            "seed 3; vae: seeds 3, 4");
  EXPECT_THAT(paragraphs().back(),
              AllOf(StartsWith("Left out, because"), HasSubstr("seeds 3, 4. To")));
}

}  // namespace
}  // namespace piae::report
