#include "plan/parts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plan/requests.hpp"

namespace piae::plan {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

class PartsOfARequest : public Requests {};

TEST_F(PartsOfARequest, GiveTheBaselineNearestWithAnyClassifiers) {
  request_.classifiers = "wdcnn-spectrum";
  const Choice choice = choose(experiment_, request_);
  EXPECT_THAT(choice.parts.front().cells,
              testing::Contains(run::Combination{"none", "100to1", "nearest"}));
}

TEST_F(PartsOfARequest, LeaveOutMethodsThatNeedKnownWindows) {
  run_.write("datasets/real.toml", "name = \"real\"\n[split]\nknown-per-class = 0\n");
  experiment_ = read_experiment(run_.pipeline.path());
  request_.methods = "none smote piae-dt-zero";
  request_.ratios = std::nullopt;
  request_.datasets = "real";
  request_.classifiers = "exclusion-rule nearest";
  const Choice choice = choose(experiment_, request_);
  EXPECT_THAT(choice.notices,
              ElementsAre("real: no fault window is known, so these are left out: smote"));
  EXPECT_THAT(choice.parts.front().methods, ElementsAre("none", "piae-dt-zero"));
  request_.methods = "smote";
  request_.classifiers = "wdcnn";
  EXPECT_THAT(refusal(), HasSubstr("real: nothing is left to run; no fault window is known"));
}

TEST_F(PartsOfARequest, RefuseAMethodIfTheDescriptionLacksKeys) {
  run_.write("datasets/real.toml",
             "name = \"real\"\n[bearing]\n[[class]]\nname = \"a\"\ndefect = \"outer\"\n");
  experiment_ = read_experiment(run_.pipeline.path());
  request_.datasets = "real";
  request_.methods = "none smote piae-dt-phase";
  EXPECT_EQ(refusal(),
            "METHODS: piae-dt-phase cannot be run; the description of real lacks what they need: "
            "defect_size_mm of every fault; choose METHODS=\"none smote\"");
  request_.methods = std::nullopt;
  const Choice choice = choose(experiment_, request_);
  ASSERT_THAT(choice.notices, SizeIs(1));
  EXPECT_THAT(choice.notices.front(), StartsWith("real: left out: dynamics "));
}

TEST(LinesOfNotices, NameEachTextOnce) {
  EXPECT_THAT(
      notice_lines({{"a", "no size"}, {"b", "no bearing"}, {"c", "no size"}, {"d", "no size"}}),
      ElementsAre("a and 2 more: no size", "b: no bearing"));
}

}  // namespace
}  // namespace piae::plan
