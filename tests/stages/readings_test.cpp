#include <gtest/gtest.h>

#include <cmath>

#include "stages/tiny.hpp"

/// Tables of the paper's interpretations, from cells of the other stages.
namespace piae::stages {
namespace {

const Arguments readings{
    "--run",      "run", "--dataset",   "tiny",
    "--readings", "a=b", "--ratios",    "50to1",
    "--seeds",    "0",   "--published", std::string(PIAE_SOURCE) + "/results/published"};

/// The chain's own cell is the base; a second one with class batches is the other interpretation.
class ReadingsStage : public testing::Test {
 protected:
  void SetUp() override {
    tiny_.run_chain_before("tabulate");
    for (const std::string role : {"A", "B", "C", "D"}) {
      fs::copy(tiny_ / (role + ".h5"), tiny_ / ("run/tiny/seed0/" + role + ".h5"));
    }
    for (const std::string name : {"base", "a-b"}) make_cell("run/tiny/seed0/readings/" + name);
  }

  void make_cell(const std::string& folder) const {
    fs::create_directories(tiny_ / (folder + "/50to1/wdcnn"));
    fs::copy(tiny_ / "model.h5", tiny_ / (folder + "/model.h5"));
    fs::copy(tiny_ / "E.h5", tiny_ / (folder + "/E.h5"));
    fs::copy(tiny_ / "run/tiny/seed0/piae-dt/score.h5", tiny_ / (folder + "/score.h5"));
    fs::copy(tiny_ / "run/tiny/seed0/piae-dt/50to1/wdcnn/diagnosis.h5",
             tiny_ / (folder + "/50to1/wdcnn/diagnosis.h5"));
  }

  const Tiny tiny_;
};

TEST_F(ReadingsStage, MakesTheTables) {
  const Outcome outcome = tiny_.run("readings", readings);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "tabulated 2 interpretations: run/tiny/readings.md\n");
  const std::string csv = bytes_of(tiny_ / "run/tiny/readings.csv");
  for (const std::string row :
       {"base,accuracy,50to1", "base,nearest,50to1", "a=b,mmd,", "a=b,L_DDL,",
        "base,gamma_of_stationary,", "base,open_contacts,", "base,damping_spread,",
        "base,stiffness_r2,", "a=b,damping_bias,"}) {
    EXPECT_NE(csv.find("\ntiny," + row + ",1,"), std::string::npos) << row << '\n' << csv;
  }
}

/// Returns the number after `begin` at the start of a line, or NaN if no line starts so.
double value_behind(const std::string& csv, const std::string& begin) {
  const std::size_t line = csv.find('\n' + begin);
  return line == std::string::npos ? NAN : std::stod(csv.substr(line + 1 + begin.size()));
}

/// The table's weights and losses are those of the model.
TEST_F(ReadingsStage, ShowsTheDistanceOfWeightsFromTheStationaryPoint) {
  ASSERT_EQ(tiny_.run("readings", readings).status, 0);
  const std::string csv = bytes_of(tiny_ / "run/tiny/readings.csv");
  const auto value = [&](const std::string& quantity) {
    return value_behind(csv, "tiny,base," + quantity + ",,1,");
  };
  for (const auto& [weight, loss] :
       {std::pair("alpha", "L_DDL"), std::pair("beta", "L_DT"), std::pair("gamma", "L_Rec")}) {
    const double expected = 2 * value(weight) * value(loss);
    EXPECT_NEAR(value(std::string(weight) + "_of_stationary"), expected, 1e-5 * expected) << weight;
  }
}

/// `identify` compares the same model with the same truth.
TEST_F(ReadingsStage, AgreesWithIdentify) {
  ASSERT_EQ(tiny_.run("readings", readings).status, 0);
  fs::copy(tiny_ / "model.h5", tiny_ / "run/tiny/seed0/piae-dt/model.h5");
  ASSERT_EQ(tiny_
                .run("identify",
                     {"--run", "run", "--dataset", "tiny", "--methods", "piae-dt", "--seeds", "0"})
                .status,
            0);
  const std::string readings_csv = bytes_of(tiny_ / "run/tiny/readings.csv");
  const std::string identify_csv = bytes_of(tiny_ / "run/tiny/identifiability.csv");
  for (const std::string parameter : {"stiffness", "damping"}) {
    const double expected = value_behind(identify_csv, "tiny,piae-dt," + parameter + ",all,1,");
    EXPECT_NEAR(value_behind(readings_csv, "tiny,base," + parameter + "_r2,,1,"), expected,
                1e-4 * std::abs(expected))
        << readings_csv << identify_csv;
  }
}

TEST_F(ReadingsStage, NamesAMissingCell) {
  fs::remove(tiny_ / "run/tiny/seed0/readings/a-b/E.h5");
  expect_refusal(tiny_.run("readings", readings), "readings", 66,
                 {"run/tiny/seed0/readings/a-b/E.h5"});
  EXPECT_FALSE(fs::exists(tiny_ / "run/tiny/readings.csv"));
}

}  // namespace
}  // namespace piae::stages
