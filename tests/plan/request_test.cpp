#include "plan/request.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plan/requests.hpp"

namespace piae::plan {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

TEST_F(Requests, NameOnlyWhatExists) {
  request_.datasets = "nowhere";
  EXPECT_EQ(refusal(), "DATASETS: unknown 'nowhere'; choose from: made real");
  request_ = run_.request;
  request_.ratios = "3to1";
  EXPECT_THAT(refusal(), HasSubstr("RATIOS: unknown '3to1'; choose from: 100to1 "));
  request_ = run_.request;
  request_.methods = "magic";
  EXPECT_THAT(refusal(), HasSubstr("METHODS: unknown 'magic'; choose from: none dynamics smote "));
  request_ = run_.request;
  request_.classifiers = "svm";
  EXPECT_THAT(refusal(), HasSubstr("CLASSIFIERS: unknown 'svm'; choose from: wdcnn "));
  request_ = run_.request;
  request_.goals = {"tabels"};
  EXPECT_THAT(refusal(), HasSubstr("unknown goal 'tabels'; choose from: records cells "));
}

TEST_F(Requests, NameNothingTwice) {
  request_.methods = "smote smote";
  EXPECT_EQ(refusal(), "METHODS: 'smote smote' names the same item twice; remove one");
  request_ = run_.request;
  request_.methods = "paper smote";
  EXPECT_THAT(refusal(), HasSubstr("names the same item twice"));
  request_ = run_.request;
  request_.seeds = "1 1";
  EXPECT_EQ(refusal(), "SEEDS: '1 1' names the same item twice; remove one");
}

TEST_F(Requests, RefuseSeedsThatAreNotWholeNumbers) {
  for (const char* seeds : {"0 x", "-1", "01", "1.5"}) {
    request_.seeds = seeds;
    EXPECT_EQ(refusal(),
              "SEEDS: must be whole numbers from 0 up, not '" + std::string(seeds) + "'");
  }
}

TEST_F(Requests, RefuseARunThatCannotBeAFolder) {
  request_.run = "../t";
  EXPECT_THAT(refusal(), HasSubstr("not a path: '../t'"));
  request_.run = "reference";
  EXPECT_EQ(refusal(),
            "RUN: 'reference' cannot be the name of a run; choose another one, such as try");
  for (const char* name : {"results", "-x", ".hidden", ".."}) {
    request_.run = name;
    EXPECT_EQ(refusal(), "RUN: '" + std::string(name) +
                             "' cannot be the name of a run; choose another one, such as try");
  }
  request_.run = "two words";
  EXPECT_EQ(refusal(), "RUN: must be one word, the name of a folder under results/");
  request_.run = "results/try/";
  EXPECT_EQ(choose(experiment_, request_).folder(), "results/try");
}

TEST_F(Requests, AcceptOneWordForThePapersMethods) {
  request_.methods = "paper";
  EXPECT_THAT(choose(experiment_, request_).methods, SizeIs(10));
}

TEST_F(Requests, AreRefusedWithoutCells) {
  request_.methods = "none";
  request_.ratios = "1to1";
  EXPECT_EQ(refusal(),
            "no cells: METHODS=\"none\" RATIOS=\"1to1\"; none runs at 100to1 only, and the other "
            "methods at all other ratios");
}

TEST_F(Requests, ReportThatRivalsAreNotCompared) {
  run_.write("datasets/other.toml",
             "name = \"other\"\nlike = \"real\"\n[transfer]\nknown = [\"a\"]\ntest = [\"b\"]\n");
  run_.set("[diagnose]",
           "[transfer.one]\ndatasets = [\"other\"]\nagainst = \"strike-twin\"\n"
           "inputs = [\"strike-twin=wdcnn-spectra\", \"none=nearest-orders\"]\n[diagnose]");
  experiment_ = read_experiment(run_.pipeline.path());
  request_ = {};
  request_.datasets = "other";
  Choice choice = choose(experiment_, request_);
  EXPECT_THAT(choice.methods, ElementsAre("none", "strike-twin"));
  EXPECT_THAT(choice.notices, Not(Contains(HasSubstr("rivals"))));
  request_.datasets = "real other";
  choice = choose(experiment_, request_);
  EXPECT_THAT(choice.methods, SizeIs(12));
  EXPECT_THAT(choice.notices, Contains("other: faults are known in another condition; request such "
                                       "data sets alone, or name METHODS, to compare the rivals of "
                                       "[transfer] in the protocol"));
  request_.methods = "none shift";
  EXPECT_THAT(choose(experiment_, request_).notices, Not(Contains(HasSubstr("rivals"))));
}

TEST_F(Requests, DoNotNeedCellsForReadOnlyGoals) {
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
