#include <gtest/gtest.h>

#include "stages/tiny.hpp"

/// Methods averaged over data sets, from cells of the other stages.
namespace piae::stages {
namespace {

const Arguments transfer{"--run",         "run",           "--group", "g",        "--datasets",
                         "tiny",          "--against",     "piae-dt", "--inputs", "none=wdcnn",
                         "piae-dt=wdcnn", "--methods",     "none",    "piae-dt",  "--ratio",
                         "50to1",         "--classifiers", "wdcnn",   "--seeds",  "0"};

class TransferStage : public testing::Test {
 protected:
  void SetUp() override {
    tiny_.run_chain_before("tabulate");
    const Outcome nearest =
        tiny_.run("diagnose", {"--test", "A.h5", "--normal", "B.h5", "--known", "C.h5", "--ratio",
                               "100to1", "--seed", "0", "--classifier", "nearest", "--output",
                               "run/tiny/seed0/none/100to1/nearest/diagnosis.h5"});
    ASSERT_EQ(nearest.status, 0) << nearest.err;
  }
  const Tiny tiny_;
};

TEST_F(TransferStage, WritesTheTablesOfTheGroup) {
  const Outcome outcome = tiny_.run("transfer", transfer);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "averaged 3 pairs of method and input over 1 data sets: run/transfer@g.md\n");
  const std::string csv = bytes_of(tiny_ / "run/transfer@g.csv");
  EXPECT_NE(csv.find("\nmean,,piae-dt,against,wdcnn,1,1,50to1,mean,"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\ntiny,,none,bar,nearest,0,1,100to1,0,"), std::string::npos) << csv;
  const std::string comparisons = bytes_of(tiny_ / "run/transfer-comparisons@g.csv");
  EXPECT_NE(comparisons.find("\ng,50to1,piae-dt,wdcnn,none,nearest,1,"), std::string::npos)
      << comparisons;
  EXPECT_TRUE(bytes_of(tiny_ / "run/transfer@g.md").starts_with("# Faults known in another"));
}

TEST_F(TransferStage, ReadsTheGroupFromTheProtocol) {
  tiny_.write(
      "protocol.toml",
      "[transfer.g]\ndatasets = [\"tiny\"]\nagainst = \"piae-dt\"\n"
      "inputs = [\"none=wdcnn\", \"piae-dt=wdcnn\"]\n[transfer.other]\nagainst = \"none\"\n");
  const Outcome outcome = tiny_.run(
      "transfer", {"--config", "protocol.toml", "--run", "run", "--group", "g", "--methods", "none",
                   "piae-dt", "--ratio", "50to1", "--classifiers", "wdcnn", "--seeds", "0"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(bytes_of(tiny_ / "run/transfer@g.csv").find(",piae-dt,against,"), std::string::npos);
}

/// A seed that one of the data sets lacks is a missing cell.
TEST_F(TransferStage, NamesAMissingCellAndWritesNothing) {
  const std::set<std::string> before = tiny_.files();
  const Outcome outcome = tiny_.run("transfer", with(transfer, "--seeds", "1"));
  EXPECT_EQ(outcome.status, 66);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find("method piae-dt, ratio 50to1, seed 1: run/tiny/seed1/piae-dt/50to1/"),
            std::string::npos)
      << outcome.err;
  EXPECT_EQ(tiny_.files(), before);
}

TEST_F(TransferStage, RefusesCellsOfAnotherDataset) {
  fs::copy(tiny_ / "run/tiny", tiny_ / "run/other", fs::copy_options::recursive);
  const Outcome outcome = tiny_.run("transfer", with(transfer, "--datasets", "other"));
  EXPECT_EQ(outcome.status, 65);
  EXPECT_NE(outcome.err.find("the data set is tiny, here it must be other"), std::string::npos)
      << outcome.err;
}

TEST_F(TransferStage, RefusesAnUnknownClassifier) {
  expect_refusal(tiny_.run("transfer", with(transfer, "--classifiers", "wdcnn,cnn")), "transfer", 2,
                 {"unknown classifier 'cnn'"});
}

}  // namespace
}  // namespace piae::stages
