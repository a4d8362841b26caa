#include "plan/experiment.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plan/stage_settings.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::plan {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Field;

std::vector<std::string> unknown_in(const Folder& pipeline) {
  std::vector<std::string> names;
  for (const Dataset& dataset : read_experiment(pipeline.path()).datasets) {
    if (!dataset.any_known) names.push_back(dataset.name);
  }
  return names;
}

TEST(Experiments, IsThatOfPipeline) {
  const Experiment own = read_experiment(std::filesystem::path(PIAE_SOURCE) / "pipeline");
  ASSERT_NE(own.find("simulated"), nullptr);
  EXPECT_TRUE(own.find("simulated")->is_simulated);
  EXPECT_FALSE(own.find("cwru")->is_simulated);
  EXPECT_FALSE(own.find("cwru")->is_transfer);
  EXPECT_TRUE(own.find("hit-sm-1200to900")->is_transfer);
  EXPECT_TRUE(own.find("uestc-true-800to1000")->is_transfer);
  EXPECT_FALSE(own.find("hit-sm-types-1200to900")->is_transfer);  // no fault window is known
  EXPECT_THAT(own.sweeps, Contains(Field(&settings::Sweep::method, "strike-twin")));
  EXPECT_THAT(own.sweeps.front().points, Contains("depth=1"));
  EXPECT_THAT(own.sweeps.front().centre, Contains("depth=3"));
  EXPECT_THAT(own.readings, Contains("batches=class"));
  EXPECT_THAT(own.readings_base, Contains("batches=mixed"));
  EXPECT_THAT(own.groups, Contains(Field(&settings::Group::name, "speeds")));
  EXPECT_EQ(own.find("nowhere"), nullptr);
}

TEST(Experiments, AcceptsBrokenDescriptionsUntilTheyAreRequested) {
  const Folder pipeline;
  pipeline.write("protocol.toml", "");
  pipeline.write("datasets/broken.toml", "name = \n");
  pipeline.write("datasets/made.toml", "[simulation]\n");
  pipeline.write("datasets/like.toml", "name = \"like\"\nlike = \"made\"\n[split]\nwindow = 3\n");
  const Experiment experiment = read_experiment(pipeline.path());
  ASSERT_NE(experiment.find("broken"), nullptr);
  EXPECT_TRUE(experiment.find("made")->is_simulated);
  EXPECT_TRUE(experiment.find("like")->is_simulated);
  EXPECT_TRUE(experiment.find("like")->has_own_split);
  EXPECT_FALSE(experiment.find("made")->has_own_split);
  StageSettings settings(experiment, "run");
  EXPECT_ERROR((void)settings.description(*experiment.find("broken")), Exit::bad_input,
               "broken.toml, line 1: not valid TOML");
}

TEST(Experiments, KnowsDataSetsWithoutKnownFaultWindows) {
  const Folder pipeline;
  pipeline.write("protocol.toml", "");
  pipeline.write("datasets/five.toml", "name = \"five\"\n[split]\nknown-per-class = 5\n");
  pipeline.write("datasets/said.toml", "name = \"said\"\n");
  pipeline.write("datasets/zero.toml", "name = \"zero\"\n[split]\nknown-per-class = 0\n");
  pipeline.write("datasets/zero-wide.toml",
                 "name = \"zero-wide\"\nlike = \"zero\"\n[split]\nwindow = 3\n");
  EXPECT_THAT(unknown_in(pipeline), ElementsAre("zero", "zero-wide"));
  pipeline.write("protocol.toml", "[split]\nknown-per-class = 0\n");
  EXPECT_THAT(unknown_in(pipeline), ElementsAre("said", "zero", "zero-wide"));
}

}  // namespace
}  // namespace piae::plan
