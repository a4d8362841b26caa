#include <gtest/gtest.h>

#include "stages/tiny.hpp"

/// (k, c) of a model against the truth, from artefacts of the other stages.
namespace piae::stages {
namespace {

const Arguments identify{"--run",     "run",     "--dataset", "tiny",
                         "--methods", "piae-dt", "--seeds",   "0"};

class IdentifyStage : public testing::Test {
 protected:
  void SetUp() override {
    tiny_.run_chain_before("generate");
    fs::create_directories(tiny_ / "run/tiny/seed0/piae-dt");
    fs::copy(tiny_ / "model.h5", tiny_ / "run/tiny/seed0/piae-dt/model.h5");
    fs::copy(tiny_ / "D.h5", tiny_ / "run/tiny/seed0/D.h5");
  }
  const Tiny tiny_;
};

TEST_F(IdentifyStage, MakesTheTables) {
  const Outcome outcome = tiny_.run("identify", identify);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "compared (k, c) of 1 models with the truth: run/tiny/identifiability.md\n");
  const std::string csv = bytes_of(tiny_ / "run/tiny/identifiability.csv");
  EXPECT_NE(csv.find("\ntiny,piae-dt,stiffness,all,1,"), std::string::npos) << csv;
  EXPECT_NE(bytes_of(tiny_ / "run/tiny/scatter.csv").find("\ntiny,piae-dt,damping,"),
            std::string::npos);
}

TEST_F(IdentifyStage, ComparesAllModelsOfTheRun) {
  ASSERT_EQ(tiny_
                .run("train", with(with(step_of("train").arguments, "--method", "ae"), "--output",
                                   "run/tiny/seed0/ae/model.h5"))
                .status,
            0);
  EXPECT_EQ(tiny_.run("identify", identify).out,
            "compared (k, c) of 2 models with the truth: run/tiny/identifiability.md\n");
  const std::string csv = bytes_of(tiny_ / "run/tiny/identifiability.csv");
  EXPECT_NE(csv.find("\ntiny,ae,stiffness,all,1,"), std::string::npos) << csv;
  Arguments without = identify;
  without.insert(without.end(), {"--leave-out", "seed0/ae"});
  EXPECT_EQ(tiny_.run("identify", without).out,
            "compared (k, c) of 1 models with the truth: run/tiny/identifiability.md\n");
}

TEST_F(IdentifyStage, NamesAMissingModel) {
  expect_refusal(tiny_.run("identify", with(identify, "--seeds", "1")), "identify", 66,
                 {"run/tiny/seed1/piae-dt/model.h5"});
}

TEST_F(IdentifyStage, RefusesAModelOfAnotherPlace) {
  fs::copy(tiny_ / "run/tiny/seed0", tiny_ / "run/tiny/seed1", fs::copy_options::recursive);
  expect_refusal(tiny_.run("identify", with(identify, "--seeds", "1")), "identify", 65,
                 {"run/tiny/seed1/piae-dt/model.h5", "seed 0, but must have piae-dt, seed 1"});
}

TEST_F(IdentifyStage, RefusesAMethodThatDoesNotInfer) {
  ASSERT_EQ(tiny_
                .run("train", {"--method", "smote", "--known", "C.h5", "--seed", "0", "--output",
                               "run/tiny/seed0/smote/model.h5"})
                .status,
            0);
  expect_refusal(tiny_.run("identify", with(identify, "--methods", "smote")), "identify", 2,
                 {"run/tiny/seed0/smote/model.h5", "infers neither"});
}

}  // namespace
}  // namespace piae::stages
