#include <gtest/gtest.h>

#include "artefact/reader.hpp"
#include "stages/tiny.hpp"

/// The only entry of the grid that may open D.
namespace piae::stages {
namespace {

const Arguments train{"--method", "oracle", "--known", "C.h5",     "--real",
                      "D.h5",     "--seed", "0",       "--output", "oracle.h5"};
const Arguments generate{"--model", "oracle.h5", "--count",  "25",
                         "--seed",  "0",         "--output", "oracle_E.h5"};
const Arguments diagnose =
    with(with(step_of("diagnose").arguments, "--generated", "oracle_E.h5"), "--output", "cell.h5");

class Oracle : public testing::Test {
 protected:
  void SetUp() override { tiny_.run_chain_before("generate"); }

  void run_well(const std::string& stage, const Arguments& arguments) const {
    const Outcome outcome = tiny_.run(stage, arguments);
    ASSERT_EQ(outcome.status, 0) << stage << ": " << outcome.err;
  }
  /// Splits the records again, with another option, into the folder "other".
  void split_again(const std::string& option, const std::string& value) const {
    fs::create_directory(tiny_ / "other");
    run_well("split",
             with(with(step_of("split").arguments, option, value), "--output-dir", "other"));
  }

  const Tiny tiny_;
};

TEST_F(Oracle, UsesRealWindowsInsteadOfGeneratedOnes) {
  run_well("train", train);
  run_well("generate", generate);
  run_well("diagnose", diagnose);
  run_well("verify", {"oracle.h5", "oracle_E.h5", "cell.h5"});
  EXPECT_EQ(artefact::Reader(tiny_ / "cell.h5", "diagnosis").text("/", "method"), "oracle");
}

TEST_F(Oracle, NeedsDOfItsOwnSplit) {
  expect_refusal(tiny_.run("train", with(train, "--real", "C.h5")), "train", 65,
                 {"C.h5", "role C", "must have role D"});
  split_again("--seed", "1");
  expect_refusal(tiny_.run("train", with(train, "--real", "other/D.h5")), "train", 65,
                 {"other/D.h5", "not belong to one split"});
  split_again("--protocol", "blocked");
  expect_refusal(tiny_.run("train", with(train, "--real", "other/D.h5")), "train", 65,
                 {"other/D.h5", "protocol"});
  // The seed and protocol are the same, but C's windows are now in D.
  split_again("--test-per-class", "2");
  expect_refusal(tiny_.run("train", with(train, "--real", "other/D.h5")), "train", 65,
                 {"roles C and D share a window"});
  EXPECT_FALSE(fs::exists(tiny_ / "oracle.h5"));
}

TEST_F(Oracle, OfAnotherSplitIsRefused) {
  run_well("train", train);
  run_well("generate", generate);
  split_again("--seed", "1");
  Arguments other = diagnose;
  for (const auto& [option, role] :
       {std::pair{"--test", "A"}, std::pair{"--normal", "B"}, std::pair{"--known", "C"}}) {
    other = with(other, option, "other/" + std::string(role) + ".h5");
  }
  expect_refusal(tiny_.run("diagnose", other), "diagnose", 65, {"oracle_E.h5", "other/C.h5"});
}

TEST_F(Oracle, IsTheOnlyMethodThatTakesD) {
  expect_refusal(tiny_.run("train", with(train, "--method", "smote")), "train", 2, {"--real"});
  Arguments without = train;
  without.erase(without.begin() + 4, without.begin() + 6);
  expect_refusal(tiny_.run("train", without), "train", 2, {"--real", "required"});
}

TEST_F(Oracle, MakesNoWindows) {
  run_well("train", train);
  expect_refusal(tiny_.run("generate", with(generate, "--count", "26")), "generate", 2,
                 {"25 real windows"});
}

}  // namespace
}  // namespace piae::stages
