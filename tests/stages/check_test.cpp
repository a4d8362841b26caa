#include <gtest/gtest.h>

#include "stages/tiny.hpp"

namespace piae::stages {
namespace {

const Arguments compared{"--run", "run", "--reference", "reference"};

class CheckStage : public testing::Test {
 protected:
  void SetUp() override { tiny_.run_chain_before("tabulate"); }
  void store() const {
    const Outcome stored = tiny_.run("check", with_flag("--store"));
    ASSERT_EQ(stored.status, 0) << stored.err;
    EXPECT_EQ(stored.out, "stored 9 numbers of tiny: reference/random/tiny.csv\n");
  }
  static Arguments with_flag(const std::string& flag) {
    Arguments arguments = compared;
    arguments.push_back(flag);
    return arguments;
  }

  Tiny tiny_;
};

TEST_F(CheckStage, StoredRunEqualsItself) {
  store();
  const Outcome same = tiny_.run("check", compared);
  EXPECT_EQ(same.status, 0) << same.err;
  EXPECT_NE(same.out.find("compared 9 quantities of tiny: 0 moved, 0 outside the tolerance\n"),
            std::string::npos)
      << same.out;
  // Values of another build are judged by their spread, which a single seed does not have.
  std::string text = bytes_of(tiny_ / "reference/random/tiny.csv");
  const std::string mark = "computed with: ";
  text.insert(text.find(mark) + mark.size(), "another machine, ");
  const std::size_t last_value = text.rfind(',') + 1;
  text.replace(last_value, std::string::npos, "1e9\n");
  write_bytes(tiny_ / "reference/random/tiny.csv", text);
  const Outcome other = tiny_.run("check", compared);
  EXPECT_EQ(other.status, 1);
  EXPECT_NE(other.out.find("1 moved, 1 outside"), std::string::npos) << other.out;
  EXPECT_NE(other.err.find("check: run differs from the reference on 1 of 1 data sets"),
            std::string::npos)
      << other.err;
}

TEST_F(CheckStage, RefusesWhatItCannotCompare) {
  expect_refusal(tiny_.run("check", compared), "check", 66,
                 {"reference/random/tiny.csv", "with `make reference RUN=...`"});
  store();
  expect_refusal(tiny_.run("check", with(compared, "--run", "nowhere")), "check", 66,
                 {"nowhere: has none of the requested diagnoses"});
  expect_refusal(tiny_.run("check", with(compared, "--seeds", "5")), "check", 66,
                 {"run: has none of the requested diagnoses, scores"});
  expect_refusal(tiny_.run("check", with(compared, "--tolerance", "some")), "check", 2,
                 {"--tolerance", "exact", "spread"});
  expect_refusal(tiny_.run("check", with(compared, "--ratios", "7to1")), "check", 2, {"7to1"});
  const std::string cell = chain()[5].outputs.front();
  write_bytes(tiny_ / cell, bytes_of(tiny_ / cell).substr(0, 1000));
  expect_refusal(tiny_.run("check", compared), "check", 65, {cell});
}

}  // namespace
}  // namespace piae::stages
