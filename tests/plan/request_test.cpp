#include "plan/request.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plan/requests.hpp"

namespace piae::plan {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

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
  for (const char* name : {"results", "-x", ".hidden", ".."}) {
    request_.run = name;
    EXPECT_EQ(refusal(), "RUN: '" + std::string(name) + "' cannot be the name of a run");
  }
  request_.run = "two words";
  EXPECT_EQ(refusal(), "RUN: one word, the name of a folder under results/");
  request_.run = "results/try/";
  EXPECT_EQ(choose(experiment_, request_).folder(), "results/try");
}

TEST_F(Requests, KnowThePapersMethodsByOneWord) {
  request_.methods = "paper";
  EXPECT_THAT(choose(experiment_, request_).methods, SizeIs(10));
}

TEST_F(Requests, HaveCells) {
  request_.methods = "none";
  request_.ratios = "1to1";
  EXPECT_EQ(
      refusal(),
      "no cells: METHODS=\"none\" RATIOS=\"1to1\"; none is run at 100to1 only, the others at all "
      "other ratios");
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
