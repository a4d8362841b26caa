#include "diagnosis/folds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "diagnosis/sets.hpp"
#include "diagnosis/training_set.hpp"
#include "support/errors.hpp"

namespace piae::diagnosis {
namespace {

using signal::WindowSet;
using testing::ElementsAre;

class FoldsOfToys : public testing::Test {
 protected:
  FoldsOfToys() {
    add(normal_, 0, 10, 100);
    add(known_, 1, 7, 200);
    add(known_, 2, 6, 300);
    for (std::size_t i = 0; i < 4; ++i) {
      add(generated_, 2, 1, 500 + static_cast<float>(i));
      add(generated_, 1, 1, 400 + static_cast<float>(i));
    }
  }
  [[nodiscard]] Folds folds(bool with_generated = false) const {
    const WindowSet* const generated = with_generated ? &generated_ : nullptr;
    const std::int64_t per_class = with_generated ? 3 : 0;
    return folds_of(compose_training_set(normal_, known_, generated, per_class),
                    {.normal = normal_,
                     .known = known_,
                     .generated = generated,
                     .generated_per_class = per_class});
  }
  /// Returns the folds that do not train on a window.
  static std::vector<std::size_t> left_out_in(const Folds& folds, std::size_t window) {
    std::vector<std::size_t> in;
    for (std::size_t fold = 0; fold < 5; ++fold) {
      if (folds.left_out[window][fold]) in.push_back(fold);
    }
    return in;
  }

  WindowSet normal_ = empty_set(4);
  WindowSet known_ = empty_set(4);
  WindowSet generated_ = empty_set(4);
};

TEST_F(FoldsOfToys, CutHealthyWindowsByTimeAndDealKnownOnesInTurn) {
  const Folds cut = folds();
  EXPECT_THAT(cut.tested, ElementsAre(0, 0, 1, 1, 2, 2, 3, 3, 4, 4,  // B
                                      0, 1, 2, 3, 4, 0, 1,           // C, class 1
                                      0, 1, 2, 3, 4, 0));            // C, class 2
  EXPECT_TRUE(cut.possible);
  for (std::size_t i = 0; i < cut.tested.size(); ++i) {
    EXPECT_THAT(left_out_in(cut, i), ElementsAre(static_cast<std::size_t>(cut.tested[i]))) << i;
  }
}

// Two recordings: the second begins when the first ends, whatever the order of the windows.
TEST_F(FoldsOfToys, BlocksFollowTimeNotOrder) {
  normal_.record_names = {"a", "b"};
  normal_.record = {1, 1, 1, 1, 1, 0, 0, 0, 0, 0};
  normal_.first_sample = {40, 30, 20, 10, 0, 0, 10, 20, 30, 40};
  EXPECT_THAT(blocks_of_time(normal_), ElementsAre(4, 4, 3, 3, 2, 0, 0, 1, 1, 2));
}

TEST_F(FoldsOfToys, BlocksDifferByOneWindowAtMost) {
  WindowSet seven = empty_set(4);
  add(seven, 0, 7, 0);
  EXPECT_THAT(blocks_of_time(seven), ElementsAre(0, 0, 1, 2, 2, 3, 4));
}

// Classes alternate in E, and the first three windows of each are trained on; these were made of
// the following known windows.
TEST_F(FoldsOfToys, GeneratedWindowIsNotTrainedWhereItsParentIsTested) {
  generated_.parents = {{7, 8}, {0}, {9, 7}, {5, 6}, {12}, {3, 1}, {8}, {2}};
  const Folds cut = folds(true);
  const WindowSet& generated = generated_;
  const std::vector<std::size_t> first{1, 3, 5, 0, 2, 4};  // of class 1, then of class 2
  ASSERT_EQ(cut.tested.size(), 23U + 6);
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(cut.tested[23 + i], Folds::none);
    for (const std::int32_t parent : generated.parents[first[i]]) {
      const std::int32_t fold = cut.tested[10 + static_cast<std::size_t>(parent)];
      EXPECT_TRUE(cut.left_out[23 + i][static_cast<std::size_t>(fold)]) << i;
    }
  }
  EXPECT_THAT(left_out_in(cut, 23), ElementsAre(0));     // parent: known 0
  EXPECT_THAT(left_out_in(cut, 24), ElementsAre(0, 1));  // parents: 5 and 6
  EXPECT_THAT(left_out_in(cut, 27), ElementsAre(0, 2));  // parents: 9 and 7, class 2
  EXPECT_THAT(left_out_in(cut, 28), ElementsAre(0));     // parent: 12, the sixth of class 2
  EXPECT_TRUE(cut.possible);
}

TEST_F(FoldsOfToys, WindowWithoutParentsIsInEveryTrainingSet) {
  const Folds cut = folds(true);
  for (std::size_t i = 23; i < 29; ++i) {
    EXPECT_THAT(left_out_in(cut, i), ElementsAre());
    EXPECT_EQ(cut.tested[i], Folds::none);
  }
}

TEST_F(FoldsOfToys, WithoutKnownWindowsGeneratedOnesAreTested) {
  known_ = empty_set(4);
  const Folds cut = folds(true);
  EXPECT_THAT(std::vector(cut.tested.begin() + 10, cut.tested.end()),
              ElementsAre(0, 1, 2, 0, 1, 2));
  EXPECT_TRUE(cut.possible);
}

TEST_F(FoldsOfToys, NeedTwoWindowsOfEachClass) {
  known_ = empty_set(4);
  add(known_, 1, 5, 200);
  add(known_, 2, 1, 300);
  EXPECT_FALSE(folds().possible);
  EXPECT_TRUE(folds(true).possible);  // one generated window without parents remains
}

TEST_F(FoldsOfToys, NeedAFaultWindow) {
  known_ = empty_set(4);
  EXPECT_FALSE(folds().possible);
}

TEST_F(FoldsOfToys, NeedFilesOfOneSplit) {
  generated_.parents = {{7}, {0}, {9}, {13}, {12}, {3}, {8}, {2}};
  EXPECT_ERROR(folds(true), Exit::bad_input,
               "--generated: a window was made from known window 13, but --known holds 13 windows");
}

}  // namespace
}  // namespace piae::diagnosis
