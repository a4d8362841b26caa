#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artefact/reader.hpp"
#include "classification/record.hpp"
#include "stages/tiny.hpp"

/// Teaches a network for all machines, and applies it to one.
namespace piae::stages {
namespace {

using testing::HasSubstr;

class Teach : public testing::Test {
 protected:
  void SetUp() override {
    tiny_.write("rig.toml", described_bearing("rig") + described_normal + described_ir007 +
                                described_or021 + described_simulation("1", "2") + "snr_db = 10\n");
    ASSERT_EQ(tiny_.run("simulate", {"--description", "rig.toml", "--output", "rig.h5"}).status, 0);
  }
  static Arguments classify() {
    return {"--classifier", stored_network(), "--records", "rig.h5", "--healthy", "Normal-01"};
  }
  void expect_refused(const std::string& stage, const Arguments& all, int status,
                      const std::vector<std::string>& words) const {
    const auto before = tiny_.files();
    expect_refusal(tiny_.run(stage, all), stage, status, words);
    EXPECT_EQ(tiny_.files(), before);
  }

  const Tiny tiny_;
};

TEST_F(Teach, MakesTheSameContentsAgainAndPassesVerify) {
  for (const std::string file : {"once.h5", "again.h5"}) {
    const Outcome outcome =
        tiny_.run("teach", {"--machines", "3", "--prewhitening", "1", "--output", file});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out, testing::StartsWith("taught 120 windows of 3 machines, "));
  }
  EXPECT_EQ(artefact::Reader(tiny_ / "again.h5", "any-bearing").digest(),
            artefact::Reader(tiny_ / "once.h5", "any-bearing").digest());
  const Outcome verified = tiny_.run("verify", {"once.h5"});
  EXPECT_EQ(verified.status, 0) << verified.out;
}

TEST_F(Teach, NamesTheFaultsOfAMachineThatItDoesNotKnow) {
  const Outcome outcome = tiny_.run("classify", with(classify(), "--output", "out.h5"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\nby any-bearing, taught on simulated machines, against 20 "
                                     "healthy windows of rig\n"));
  EXPECT_THAT(outcome.out, testing::ContainsRegex("\nNormal-01 +Normal +healthy "));
  EXPECT_THAT(outcome.out, testing::ContainsRegex("\nIR007-01 +IR007 +inner "));
  EXPECT_THAT(outcome.out, testing::ContainsRegex("\nOR021-01 +OR021 +outer "));
  const Outcome verified = tiny_.run("verify", {"out.h5"});
  EXPECT_EQ(verified.status, 0) << verified.out;
}

TEST_F(Teach, IsAClassifierOfTheGrid) {
  tiny_.run_chain_before("diagnose");
  const Outcome outcome =
      tiny_.run("diagnose", {"--test", "A.h5", "--normal", "B.h5", "--known", "C.h5", "--ratio",
                             "100to1", "--seed", "0", "--classifier", "any-bearing", "--network",
                             stored_network(), "--output", "diagnosis.h5"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("any-bearing"));
}

TEST_F(Teach, IsRefusedWithoutHealthyRecords) {
  const std::string words = "needs healthy records of this one: give --description or --records";
  expect_refused("classify", {"--classifier", stored_network(), "--records", "rig.h5"}, 2, {words});
  tiny_.write("recording.csv", "1\n2\n");
  expect_refused(
      "classify",
      {"--classifier", stored_network(), "--recording", "recording.csv", "--variable", "1",
       "--speed-rpm", "1797", "--sample-rate-hz", "12000", "--healthy", "Normal-01"},
      2, {words});
  expect_refused("classify",
                 {"--classifier", stored_network(), "--records", "rig.h5", "--healthy", "Norm"}, 2,
                 {"does not have a record 'Norm'; known: IR007-01 Normal-01 OR021-01"});
}

TEST_F(Teach, RefusesAFaultyRecordAsTheHealthyReference) {
  expect_refused("classify",
                 {"--classifier", stored_network(), "--records", "rig.h5", "--healthy", "IR007-01"},
                 2,
                 {"--healthy: record IR007-01 is of class IR007, which has a defect; name "
                  "records of class Normal"});
}

TEST_F(Teach, RefusesOtherArtefacts) {
  expect_refused("classify", {"--classifier", "rig.h5", "--records", "rig.h5"}, 65,
                 {"rig.h5: is an artefact of kind 'records', not 'classifier'"});
  tiny_.run_chain_before("diagnose");
  expect_refused("diagnose",
                 {"--test", "A.h5", "--normal", "B.h5", "--known", "C.h5", "--ratio", "100to1",
                  "--seed", "0", "--classifier", "any-bearing", "--output", "x.h5"},
                 2, {"--classifier any-bearing needs --network"});
  expect_refused(
      "diagnose",
      {"--test", "A.h5", "--normal", "B.h5", "--known", "C.h5", "--ratio", "100to1", "--seed", "0",
       "--classifier", "any-bearing", "--network", "rig.h5", "--output", "x.h5"},
      65, {"rig.h5: is an artefact of kind 'records', not 'any-bearing'"});
}

}  // namespace
}  // namespace piae::stages
