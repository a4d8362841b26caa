#include <gtest/gtest.h>

#include "stages/tiny.hpp"

/// Tables of a part of a run.
namespace piae::stages {
namespace {

/// The step of the chain, which asks for all cells, with other options.
Arguments asking_for(const std::string& methods, const std::string& ratios) {
  return {"--run",     "run",   "--dataset",   "tiny",
          "--methods", methods, "--ratios",    ratios,
          "--seeds",   "0",     "--published", std::string(PIAE_SOURCE) + "/results/published"};
}

std::map<std::string, std::string> tables_of(const Tiny& tiny) {
  std::map<std::string, std::string> tables;
  for (const std::string& output : step_of("tabulate").outputs) {
    tables[output] = bytes_of(tiny / output);
  }
  return tables;
}

TEST(TablesOfAPart, AreThoseOfAllThatTheRunHolds) {
  const Tiny tiny;
  tiny.run_chain_before("");
  const auto of_the_whole = tables_of(tiny);
  const Outcome outcome = tiny.run("tabulate", asking_for("none", "100to1"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(outcome.out.ends_with("tabulated 2 diagnoses and 1 scores: run/tiny/tables.md\n"))
      << outcome.out;
  EXPECT_EQ(tables_of(tiny), of_the_whole);
}

TEST(TablesOfAPart, LeaveOutWhatIsOutOfDateAndSaySo) {
  const Tiny tiny;
  tiny.run_chain_before("");
  Arguments arguments = asking_for("none", "100to1");
  arguments.insert(arguments.end(), {"--leave-out", "seed0/piae-dt", "seed1"});
  const Outcome outcome = tiny.run("tabulate", arguments);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("left out, since"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("piae-dt: seed 0"), std::string::npos) << outcome.err;
  EXPECT_EQ(bytes_of(tiny / "run/tiny/accuracy.csv").find("piae-dt"), std::string::npos);
  EXPECT_NE(bytes_of(tiny / "run/tiny/tables.md").find("Left out, since"), std::string::npos);
}

TEST(TablesOfAPart, NeedWhatIsAskedFor) {
  const Tiny tiny;
  tiny.run_chain_before("");
  const auto of_the_whole = tables_of(tiny);
  const Outcome outcome = tiny.run("tabulate", asking_for("piae-dt", "10to1"));
  EXPECT_EQ(outcome.status, 66);
  EXPECT_NE(outcome.err.find("run/tiny/seed0/piae-dt/10to1/diagnosis.h5"), std::string::npos)
      << outcome.err;
  EXPECT_EQ(tables_of(tiny), of_the_whole);
}

/// Models are no cells: a run that was copied without them has all tables but this one.
TEST(Tabulate, SaysHowTheTrainingsOfTheTwinsEndedWhereTheRunHoldsModels) {
  const Tiny tiny;
  tiny.run_chain_before("tabulate");
  const auto tables = [&] {
    const Outcome outcome = tiny.run("tabulate", step_of("tabulate").arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return bytes_of(tiny / "run/tiny/tables.md");
  };
  EXPECT_EQ(tables().find("trainings of the twins"), std::string::npos);
  fs::copy(tiny / "model.h5", tiny / "run/tiny/seed0/piae-dt/model.h5");
  const std::string text = tables();
  EXPECT_NE(text.find("## How the trainings of the twins ended on tiny"), std::string::npos);
  EXPECT_NE(text.find("2γL"), std::string::npos);
}

}  // namespace
}  // namespace piae::stages
