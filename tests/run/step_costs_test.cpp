#include "run/step_costs.hpp"

#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::run {
namespace {

const std::string header =
    "# of a machine\nstage,dataset,method,classifier,ratio,seconds,megabytes\n";

TEST(StepCosts, AreReadByLine) {
  const Folder folder;
  const auto costs = read_costs(folder.write(
      "costs.csv", header + "train,cwru,vae,,,2.5,100\ndiagnose,cwru,vae,wdcnn,1to1,4,80\n"));
  ASSERT_EQ(costs.size(), 2U);
  EXPECT_EQ(costs[0].stage, "train");
  EXPECT_EQ(costs[0].seconds, 2.5);
  EXPECT_EQ(costs[1].classifier, "wdcnn");
  EXPECT_EQ(costs[1].ratio, "1to1");
  EXPECT_EQ(costs[1].megabytes, 80);
}

TEST(StepCosts, RefuseAnotherHeaderAndCostsThatAreNotNumbers) {
  const Folder folder;
  const auto refused = [&](const std::string& text, const std::string& why) {
    const auto file = folder.write("costs.csv", text);
    EXPECT_ERROR(read_costs(file), Exit::bad_input, why);
  };
  refused(header + "train,cwru,vae,,,much,100\n", "costs.csv, line 3: seconds and megabytes must");
  refused(header + "train,cwru,vae,,,1,nan\n", "costs.csv, line 3: seconds and megabytes must");
  refused("a,b\n1,2\n", "costs.csv, line 1: the header must be stage,dataset,method,");
}

// The time to train and to generate; nothing without one of them.
TEST(StepCosts, OfAGeneratorAreTheSumOfItsSteps) {
  const auto cost = [](const char* stage, const char* dataset, const char* method, double seconds) {
    StepCost made;
    made.stage = stage;
    made.dataset = dataset;
    made.method = method;
    made.seconds = seconds;
    return made;
  };
  const std::vector<StepCost> costs{
      cost("train", "cwru", "vae", 2), cost("generate", "cwru", "vae", 0.5),
      cost("train", "cwru", "smote", 1), cost("train", "hit-sm", "vae", 7)};
  EXPECT_EQ(generator_seconds(costs, "cwru", "vae"), 2.5);
  EXPECT_EQ(generator_seconds(costs, "cwru", "smote"), std::nullopt);
  EXPECT_EQ(generator_seconds(costs, "hit-sm", "vae"), std::nullopt);
}

}  // namespace
}  // namespace piae::run
