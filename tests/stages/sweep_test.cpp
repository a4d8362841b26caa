#include <gtest/gtest.h>

#include <fstream>

#include "stages/tiny.hpp"

/// Table of a sweep, from cells of the other stages.
namespace piae::stages {
namespace {

const Arguments sweep{"--run",    "run",     "--dataset", "tiny",  "--points", "batch=2", "batch=5",
                      "--centre", "batch=5", "--ratios",  "50to1", "--seeds",  "0"};
const std::string cell = "run/tiny/seed0/sweep/batch-2/50to1/wdcnn/diagnosis.h5";

/// Makes the second point; the chain has the common one.
void make_moved_cell(const Tiny& tiny) {
  const auto run = [&](const std::string& stage, const Arguments& arguments) {
    const Outcome outcome = tiny.run(stage, arguments);
    ASSERT_EQ(outcome.status, 0) << stage << ": " << outcome.err;
  };
  run("train", with(with(step_of("train").arguments, "--batch", "2"), "--output", "moved.h5"));
  run("generate",
      with(with(step_of("generate").arguments, "--model", "moved.h5"), "--output", "moved_E.h5"));
  run("diagnose",
      with(with(step_of("diagnose").arguments, "--generated", "moved_E.h5"), "--output", cell));
}

TEST(Sweep, TableUsesCellsOfSweepAndGrid) {
  const Tiny tiny;
  tiny.run_chain_before("tabulate");
  make_moved_cell(tiny);
  const Outcome outcome = tiny.run("sweep", sweep);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "tabulated 2 diagnoses of 2 settings: run/tiny/sweep.md\n");
  const std::string csv = bytes_of(tiny / "run/tiny/sweep.csv");
  EXPECT_TRUE(
      csv.starts_with("dataset,factor,value,ratio,seeds,mean,std,ci95_low,ci95_high\n"
                      "tiny,batch,2,50to1,1,"))
      << csv;
  EXPECT_NE(csv.find("\ntiny,batch,5,50to1,1,"), std::string::npos) << csv;
  EXPECT_NE(bytes_of(tiny / "run/tiny/sweep.md").find("as in the grid"), std::string::npos);
}

/// Makes cells of smote by `nearest`: with the protocol's number of neighbours and with another.
void make_parts(const Tiny& tiny) {
  const auto make = [&](const std::string& folder, const std::string& neighbours) {
    const std::string model = "run/tiny/seed0/" + folder + "/model.h5";
    const std::string made = "run/tiny/seed0/" + folder + "/E.h5";
    const std::vector<std::pair<std::string, Arguments>> steps{
        {"train",
         {"--method", "smote", "--neighbours", neighbours, "--known", "C.h5", "--seed", "0",
          "--output", model}},
        {"generate", with(with(step_of("generate").arguments, "--model", model), "--output", made)},
        {"diagnose", with(with(with(step_of("diagnose").arguments, "--generated", made), "--output",
                               "run/tiny/seed0/" + folder + "/50to1/nearest/diagnosis.h5"),
                          "--classifier", "nearest")}};
    for (const auto& [stage, arguments] : steps) {
      const Outcome outcome = tiny.run(stage, arguments);
      ASSERT_EQ(outcome.status, 0) << stage << ": " << outcome.err;
    }
  };
  make("smote", "3");
  make("sweep@smote/neighbours-1", "1");
}

/// Runs the steps by hand, with the protocol itself.
TEST(Sweep, ComparesAnotherMethodWithItsDefault) {
  const Tiny tiny;
  tiny.run_chain_before("tabulate");
  make_parts(tiny);
  std::ofstream(tiny / "protocol.toml")
      << "[sweep]\npoints = [\"batch=1\"]\n[sweep.smote]\npoints = [\"neighbours=1\"]\n"
         "classifier = \"nearest\"\n";
  const Arguments parts{"--config", "protocol.toml", "--run",    "run",   "--dataset", "tiny",
                        "--method", "smote",         "--ratios", "50to1", "--seeds",   "0"};
  const Outcome outcome = tiny.run("sweep", parts);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "tabulated 2 diagnoses of 2 settings: run/tiny/sweep@smote.md\n");
  const std::string csv = bytes_of(tiny / "run/tiny/sweep@smote.csv");
  EXPECT_NE(csv.find("\ntiny,smote,nearest,,,1,50to1,1,"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\ntiny,smote,nearest,neighbours,1,0,50to1,1,"), std::string::npos) << csv;
  expect_refusal(tiny.run("sweep", with(parts, "--method", "smot")), "sweep", 2, {"smot", "smote"});
}

TEST(Sweep, MissingCellIsNamedAndNothingIsWritten) {
  const Tiny tiny;
  tiny.run_chain_before("tabulate");
  const std::set<std::string> before = tiny.files();
  const Outcome outcome = tiny.run("sweep", sweep);
  EXPECT_EQ(outcome.status, 66);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find("batch 2, ratio 50to1, seed 0: "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find(cell), std::string::npos) << outcome.err;
  EXPECT_EQ(tiny.files(), before);
}

TEST(Sweep, ImpossiblePointsAreNamed) {
  const Tiny tiny;
  tiny.run_chain_before("tabulate");
  expect_refusal(tiny.run("sweep", with(sweep, "--centre", "batch=7")), "sweep", 2, {"batch=7"});
  expect_refusal(tiny.run("sweep", with(sweep, "--ratios", "100to1")), "sweep", 2, {"100to1"});
}

}  // namespace
}  // namespace piae::stages
