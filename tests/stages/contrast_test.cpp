#include <gtest/gtest.h>

#include "stages/tiny.hpp"

/// Two runs side by side, from cells of the other stages.
namespace piae::stages {
namespace {

const Arguments contrast{"--with",  "run/tiny", "--without", "other/tiny", "--methods",
                         "none",    "piae-dt",  "--ratios",  "100to1",     "50to1",
                         "--seeds", "0",        "--output",  "table.md"};

class ContrastStage : public testing::Test {
 protected:
  void SetUp() override {
    tiny_.run_chain_before("tabulate");
    fs::copy(tiny_ / "run", tiny_ / "other", fs::copy_options::recursive);
  }
  const Tiny tiny_;
};

TEST_F(ContrastStage, ComparesTwoRuns) {
  const Outcome outcome = tiny_.run("contrast", contrast);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "compared 2 cells of two runs: table.md\n");
  const std::string csv = bytes_of(tiny_ / "table.csv");
  EXPECT_NE(csv.find("\nrun,other,none,100to1,"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",1,0.0000,,,,,\nrun,other,piae-dt,50to1,"), std::string::npos) << csv;
  EXPECT_TRUE(bytes_of(tiny_ / "table.md").starts_with("# tiny: run against other\n"));
  EXPECT_NE(bytes_of(tiny_ / "table.tex").find("\\begin{tabular}"), std::string::npos);
}

TEST_F(ContrastStage, NamesAMissingCellAndWritesNothing) {
  fs::remove(tiny_ / "other/tiny/seed0/piae-dt/50to1/wdcnn/diagnosis.h5");
  const std::set<std::string> before = tiny_.files();
  const Outcome outcome = tiny_.run("contrast", contrast);
  EXPECT_EQ(outcome.status, 66);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find("method piae-dt, ratio 50to1, seed 0: other/tiny/"), std::string::npos)
      << outcome.err;
  EXPECT_EQ(tiny_.files(), before);
}

TEST_F(ContrastStage, RefusesARunAgainstItself) {
  expect_refusal(tiny_.run("contrast", with(contrast, "--without", "run/tiny/")), "contrast", 2,
                 {"--with and --without", "tiny, random"});
}

}  // namespace
}  // namespace piae::stages
