#include "plan/held_cells.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plan/small_run.hpp"

namespace piae::plan {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

TEST(HeldCells, AreRecognisedByTheirPaths) {
  const SmallRun run;
  const Experiment experiment = read_experiment(run.pipeline.path());
  const auto cells = held_cells(
      experiment, {"records.h5", "seed0/A.h5", "seed0/smote/model.h5", "seed0/smote/score.h5",
                   "seed10/smote/1to1/wdcnn/diagnosis.h5", "seed10/smote/1to1/wdcnn/features.h5"});
  ASSERT_THAT(cells, SizeIs(3));
  EXPECT_EQ(cells[0].kind, HeldCell::Kind::model);
  EXPECT_EQ(cells[1].kind, HeldCell::Kind::score);
  EXPECT_EQ(cells[2].seed, 10);
  EXPECT_EQ(cells[2].ratio, "1to1");
  EXPECT_EQ(cells[2].classifier, "wdcnn");
}

TEST(HeldCells, ExcludeUnknownFiles) {
  const SmallRun run;
  const Experiment experiment = read_experiment(run.pipeline.path());
  EXPECT_THAT(held_cells(experiment, {"seed01/smote/score.h5", "seed0/magic/score.h5",
                                      "seed0/smote/3to1/wdcnn/diagnosis.h5",
                                      "seed0/smote/1to1/svm/diagnosis.h5", "seedling/score.h5",
                                      "seed0/smote/1to1/diagnosis.h5"}),
              IsEmpty());
}

TEST(HeldCells, MayHaveASettingMoved) {
  SmallRun run;
  run.write("protocol.toml", run.protocol +
                                 "[sweep]\npoints = [\"batch=1\"]\n[readings]\n"
                                 "base = [\"depth=3\", \"batch=5\"]\n"
                                 "readings = [\"depth=4+width=8\"]\n");
  const Experiment experiment = read_experiment(run.pipeline.path());
  const auto cells = held_cells(experiment, {"seed0/sweep/batch-1/1to1/wdcnn/diagnosis.h5",
                                             "seed0/readings/depth-4+width-8/score.h5"});
  ASSERT_THAT(cells, SizeIs(2));
  EXPECT_EQ(cells[0].variant.method, "piae-dt");
  ASSERT_THAT(cells[0].variant.moved, SizeIs(1));
  EXPECT_EQ(cells[0].variant.moved[0].factor, "batch");
  std::vector<std::string> moved;
  for (const auto& point : cells[1].variant.moved)
    moved.push_back(point.factor + '=' + point.value);
  EXPECT_THAT(moved, ElementsAre("depth=4", "width=8", "batch=5"));
}

}  // namespace
}  // namespace piae::plan
