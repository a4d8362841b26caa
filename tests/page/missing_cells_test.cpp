#include <gtest/gtest.h>

#include "page/contents.hpp"

namespace piae::page {
namespace {

TEST(BelowRun, NamesFilesWithoutTheFolderOfTheRun) {
  EXPECT_EQ(below_run("results/t/cwru/A.h5: damaged ('results/t/cwru/B.h5')", "results/t"),
            "cwru/A.h5: damaged ('cwru/B.h5')");
}

TEST(BelowRun, KeepsFoldersWhoseNameEndsLikeTheRuns) {
  EXPECT_EQ(below_run("t/cwru/seed0/shift/10to1/nearest/diagnosis.h5: is empty", "t"),
            "cwru/seed0/shift/10to1/nearest/diagnosis.h5: is empty");
}

TEST(ProblemsByFile, NameTheirFile) {
  const run::Layout layout("results/t", "cwru");
  const ProblemsByFile problems(
      layout, {"method shift, seed 1: results/t/cwru/seed1/shift/score.h5: is empty",
               "method shift, seed 11: results/t/cwru/seed11/shift/score.h5: is not a file",
               "a line that names none"});
  EXPECT_EQ(problems.with(layout.score("shift", 11)),
            "results/t/cwru/seed11/shift/score.h5: is not a file");
  EXPECT_EQ(problems.with(layout.score("shift", 1)),
            "results/t/cwru/seed1/shift/score.h5: is empty");
  EXPECT_EQ(problems.with(layout.score("shift", 2)), "");
}

}  // namespace
}  // namespace piae::page
