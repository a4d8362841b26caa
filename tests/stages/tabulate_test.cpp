#include <gtest/gtest.h>

#include <sstream>

#include "stages/tiny.hpp"

/// Tables of a part of a run.
namespace piae::stages {
namespace {

/// Returns the chain's step, which requests all cells, with other methods and ratios.
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

TEST(TablesOfAPart, IncludeAllCellsOfTheRun) {
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

TEST(TablesOfAPart, LeaveOutAndReportStaleCells) {
  const Tiny tiny;
  tiny.run_chain_before("");
  Arguments arguments = asking_for("none", "100to1");
  arguments.insert(arguments.end(), {"--leave-out", "seed0/piae-dt", "seed1"});
  const Outcome outcome = tiny.run("tabulate", arguments);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("left out, because"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("piae-dt: seed 0"), std::string::npos) << outcome.err;
  EXPECT_EQ(bytes_of(tiny / "run/tiny/accuracy.csv").find("piae-dt"), std::string::npos);
  EXPECT_NE(bytes_of(tiny / "run/tiny/tables.md").find("Left out, because"), std::string::npos);
}

TEST(TablesOfAPart, NeedTheRequestedCells) {
  const Tiny tiny;
  tiny.run_chain_before("");
  const auto of_the_whole = tables_of(tiny);
  const Outcome outcome = tiny.run("tabulate", asking_for("piae-dt", "10to1"));
  EXPECT_EQ(outcome.status, 66);
  EXPECT_NE(outcome.err.find("run/tiny/seed0/piae-dt/10to1/wdcnn/diagnosis.h5"), std::string::npos)
      << outcome.err;
  EXPECT_EQ(tables_of(tiny), of_the_whole);
}

/// Models are not cells: a run copied without them has all tables but this one.
TEST(Tabulate, ReportsTheEndOfTwinTrainingsIfModelsExist) {
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

/// Returns the fields of the first line of a table that begins with `beginning`.
std::vector<std::string> fields_after(const std::string& table, const std::string& beginning) {
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(beginning)) continue;
    std::vector<std::string> fields;
    std::istringstream rest(line.substr(beginning.size()));
    for (std::string field; std::getline(rest, field, ',');) fields.push_back(field);
    return fields;
  }
  return {};
}

/// A decision over one window is what accuracy counts; A has 10 windows of each of three classes.
TEST(Tabulate, DecidesOverSeveralWindowsIfTestWindowsExist) {
  const Tiny tiny;
  tiny.run_chain_before("tabulate");
  const auto decisions = [&] {
    const Outcome outcome = tiny.run_step("tabulate");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return bytes_of(tiny / "run/tiny/decisions.csv");
  };
  EXPECT_EQ(fields_after(decisions(), "tiny,").size(), 0U);
  EXPECT_NE(bytes_of(tiny / "run/tiny/tables.md").find("are left out: the run does not hold"),
            std::string::npos);
  const std::string before = bytes_of(tiny / "run/tiny/accuracy.csv");
  fs::copy(tiny / "A.h5", tiny / "run/tiny/seed0/A.h5");
  const auto of_one = fields_after(decisions(), "tiny,piae-dt,wdcnn,50to1,1,");
  const auto accuracy =
      fields_after(bytes_of(tiny / "run/tiny/accuracy.csv"), "tiny,piae-dt,wdcnn,50to1,");
  ASSERT_GE(of_one.size(), 3U);
  ASSERT_GE(accuracy.size(), 3U);
  EXPECT_EQ(of_one[1], "30");
  EXPECT_EQ(of_one[2], accuracy[2]) << "the mean";
  EXPECT_EQ(bytes_of(tiny / "run/tiny/accuracy.csv"), before);
  EXPECT_NE(bytes_of(tiny / "run/tiny/tables.md").find("\n## Decisions over several windows"),
            std::string::npos);
  EXPECT_NE(bytes_of(tiny / "run/tiny/tables.tex").find("tab:tiny-decisions"), std::string::npos);
  EXPECT_EQ(
      fields_after(bytes_of(tiny / "run/tiny/confidence.csv"), "tiny,none,wdcnn,100to1,1,").back(),
      "1");
}

TEST(Tabulate, RefusesTestWindowsOfAnotherDiagnosis) {
  const Tiny tiny;
  tiny.run_chain_before("");
  const auto before = tables_of(tiny);
  Arguments split = with(step_of("split").arguments, "--test-per-class", "12");
  ASSERT_EQ(tiny.run("split", with(split, "--output-dir", "other")).status, 0);
  fs::copy(tiny / "other/A.h5", tiny / "run/tiny/seed0/A.h5");
  const Outcome outcome = tiny.run_step("tabulate");
  EXPECT_EQ(outcome.status, 65);
  EXPECT_NE(
      outcome.err.find("run/tiny/seed0/none/100to1/wdcnn/diagnosis.h5: /labels are not those of "
                       "A.h5 of this seed"),
      std::string::npos)
      << outcome.err;
  EXPECT_EQ(tables_of(tiny), before);
}

}  // namespace
}  // namespace piae::stages
