#include "plan/request.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "plan/small_run.hpp"

namespace piae::plan {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// The line of the error that a request ends with.
std::string refusal_of(const Experiment& experiment, const Request& request) {
  try {
    (void)choose(experiment, request);
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::usage);
    return error.what();
  }
  return "not refused";
}

class Requests : public testing::Test {
 protected:
  Requests() : experiment_(read_experiment(run_.pipeline.path())), request_(run_.request) {}

  [[nodiscard]] std::string refusal() const { return refusal_of(experiment_, request_); }

  SmallRun run_;
  Experiment experiment_;
  Request request_;
};

TEST_F(Requests, NameWhatThereIsOnly) {
  request_.datasets = "nowhere";
  EXPECT_EQ(refusal(), "DATASETS: unknown 'nowhere'; there are: made real");
  request_ = run_.request;
  request_.ratios = "3to1";
  EXPECT_THAT(refusal(), HasSubstr("RATIOS: unknown '3to1'; there are: 100to1 "));
  request_ = run_.request;
  request_.methods = "magic";
  EXPECT_THAT(refusal(), HasSubstr("METHODS: unknown 'magic'; there are: none dynamics smote "));
  request_ = run_.request;
  request_.classifiers = "svm";
  EXPECT_THAT(refusal(), HasSubstr("CLASSIFIERS: unknown 'svm'; there are: wdcnn "));
  request_ = run_.request;
  request_.goals = {"tabels"};
  EXPECT_THAT(refusal(), HasSubstr("there is no goal 'tabels'; there are: records cells "));
}

TEST_F(Requests, NameNothingTwice) {
  request_.methods = "smote smote";
  EXPECT_EQ(refusal(), "METHODS: 'smote smote' names one twice");
  request_ = run_.request;
  request_.methods = "paper smote";
  EXPECT_THAT(refusal(), HasSubstr("names one twice"));
  request_ = run_.request;
  request_.seeds = "1 1";
  EXPECT_EQ(refusal(), "SEEDS: '1 1' names one twice");
}

TEST_F(Requests, HaveSeedsThatAreWholeNumbers) {
  for (const char* seeds : {"0 x", "-1", "01", "1.5"}) {
    request_.seeds = seeds;
    EXPECT_EQ(refusal(), "SEEDS: whole numbers from 0 up, not '" + std::string(seeds) + "'");
  }
}

TEST_F(Requests, HaveARunThatCanBeAFolder) {
  request_.run = "../t";
  EXPECT_THAT(refusal(), HasSubstr("not a path: '../t'"));
  request_.run = "reference";
  EXPECT_EQ(refusal(), "RUN: 'reference' cannot be the name of a run");
  request_.run = "two words";
  EXPECT_EQ(refusal(), "RUN: one word, the name of a folder under results/");
  request_.run = "results/try/";
  EXPECT_EQ(choose(experiment_, request_).folder(), "results/try");
}

TEST_F(Requests, HaveCells) {
  request_.methods = "none";
  request_.ratios = "1to1";
  EXPECT_EQ(
      refusal(),
      "no cells: METHODS=\"none\" RATIOS=\"1to1\"; none is run at 100to1 only, the others at all "
      "other ratios");
}

TEST_F(Requests, ChooseThePapersMethodsAndWhatWeRecommendByThemselves) {
  request_.methods = std::nullopt;
  request_.datasets = "real";
  const Choice choice = choose(experiment_, request_);
  EXPECT_THAT(choice.methods, SizeIs(12));
  EXPECT_EQ(choice.methods.front(), "none");
  request_.methods = "paper";
  EXPECT_THAT(choose(experiment_, request_).methods, SizeIs(10));
}

TEST_F(Requests, GiveTheBaselineTheBarWhateverTheClassifiers) {
  request_.classifiers = "wdcnn-spectrum";
  const Choice choice = choose(experiment_, request_);
  EXPECT_THAT(choice.parts.front().cells,
              testing::Contains(run::Combination{"none", "100to1", "nearest"}));
}

TEST_F(Requests, LeaveOutWhatNeedsKnownWindowsWhereNoneIsKnown) {
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
  EXPECT_THAT(refusal(), HasSubstr("real: nothing is left to be made; no fault window is known"));
}

TEST_F(Requests, RefuseAMethodThatADescriptionDoesNotSayEnoughFor) {
  run_.write("datasets/real.toml",
             "name = \"real\"\n[bearing]\n[[class]]\nname = \"a\"\ndefect = \"outer\"\n");
  experiment_ = read_experiment(run_.pipeline.path());
  request_.datasets = "real";
  request_.methods = "none smote strike-twin";
  EXPECT_EQ(
      refusal(),
      "METHODS: strike-twin cannot be run; the description of real does not say what they need: "
      "defect_size_mm of every fault; choose METHODS=\"none smote\"");
  request_.methods = std::nullopt;
  const Choice choice = choose(experiment_, request_);
  ASSERT_THAT(choice.notices, SizeIs(1));
  EXPECT_THAT(choice.notices.front(), HasSubstr("left out: "));
}

TEST_F(Requests, ThatOnlyLookNeedNoCells) {
  request_.goals = {"figures", "report"};
  request_.datasets = std::nullopt;
  request_.methods = "none";
  request_.ratios = "1to1";
  request_.held = {"made"};
  const Choice choice = choose(experiment_, request_);
  ASSERT_THAT(choice.parts, SizeIs(1));
  EXPECT_EQ(choice.parts.front().dataset.name, "made");
  EXPECT_THAT(choice.parts.front().cells, IsEmpty());
  EXPECT_THAT(choice.given,
              ElementsAre("--methods", "none", "--ratios", "1to1", "--seeds", "0", "1"));
}

}  // namespace
}  // namespace piae::plan
