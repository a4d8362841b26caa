#include "signal/simulation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "base/error.hpp"
#include "support/description_text.hpp"

namespace piae::signal {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::string simulated_head = described_bearing("small") + described_normal;
const std::string faulty = described_or021 + R"([[class]]
name = "B007"
defect = "roller"
defect_size_mm = 0.1778
)";
const std::string table = described_simulation("4", "0.2");

class SimulationTest : public testing::Test {
 protected:
  SimulationTest() { fs::create_directories(folder_); }
  ~SimulationTest() override { fs::remove_all(folder_); }

  [[nodiscard]] Simulation read(const std::string& text) const {
    const fs::path file = folder_ / "small.toml";
    std::ofstream(file) << text;
    return read_simulation(file);
  }
  [[nodiscard]] std::string refusal(const std::string& text) const {
    try {
      (void)read(text);
    } catch (const Error& error) {
      EXPECT_EQ(error.exit(), Exit::bad_input);
      return error.what();
    }
    return "no error";
  }

 private:
  fs::path folder_ =
      fs::path(testing::TempDir()) /
      ("simulation-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

const std::string description = simulated_head + faulty + table;

double power(const std::vector<double>& signal) {
  double sum = 0;
  for (const double x : signal) sum += x * x / static_cast<double>(signal.size());
  return sum;
}

double mean_power(const Recordings& recordings, int label) {
  double sum = 0;
  int records = 0;
  for (const Record& record : recordings.records) {
    if (record.label != label) continue;
    sum += power(record.signal);
    ++records;
  }
  return sum / records;
}

TEST_F(SimulationTest, ReadsItsDescription) {
  const Simulation s = read(description + "snr_db = -3\n");
  EXPECT_EQ(s.info.name, "small");
  EXPECT_EQ(s.info.classes.size(), 3U);
  EXPECT_EQ(s.info.sample_rate_hz, 12000);
  EXPECT_EQ(s.info.bearing.outer_raceway_mm, 46.94);
  EXPECT_EQ(s.records_per_class, 4U);
  EXPECT_EQ(s.samples, 2400U);
  EXPECT_EQ(s.dynamics.stiffness_n_per_m, 1e8);
  EXPECT_EQ(s.dynamics.damping_ns_per_m, 500);
  EXPECT_EQ(s.dynamics.clearance_um, 2);
  EXPECT_EQ(s.dynamics.load_n, 1000);
  EXPECT_EQ(s.variation.stiffness_spread, 0.1);
  EXPECT_EQ(s.variation.damping_spread, 0.2);
  EXPECT_EQ(s.variation.slip_max, 0.01);
  EXPECT_EQ(s.variation.speed_spread, 0.001);
  EXPECT_EQ(s.snr_db, -3);
  EXPECT_FALSE(read(description).snr_db.has_value());
}

TEST_F(SimulationTest, StoresTrueParametersInRecords) {
  const Recordings r = simulate(read(description));
  ASSERT_EQ(r.records.size(), 12U);
  EXPECT_TRUE(std::ranges::is_sorted(r.records, {}, &Record::name));
  EXPECT_EQ(r.records.front().name, "B007-01");
  EXPECT_EQ(r.records.back().name, "OR021-04");
  std::set<double> stiffnesses;
  for (const Record& record : r.records) {
    EXPECT_EQ(record.signal.size(), 2400U);
    EXPECT_EQ(record.source, "simulated");
    EXPECT_EQ(record.original_sample_rate_hz, 12000);
    EXPECT_EQ(r.info.classes[record.label].name, record.name.substr(0, record.name.find('-')));
    EXPECT_NEAR(record.shaft_speed_rpm, 1797, 3 * 0.001 * 1797);
    ASSERT_TRUE(record.parameters.has_value());
    EXPECT_NEAR(record.parameters->stiffness_n_per_m, 1e8, 3 * 0.1 * 1e8);
    EXPECT_NEAR(record.parameters->damping_ns_per_m, 500, 3 * 0.2 * 500);
    stiffnesses.insert(record.parameters->stiffness_n_per_m);
  }
  EXPECT_EQ(stiffnesses.size(), 12U) << "each record has its own";
}

/// Returns the relative power of `signal` minus the best of many simulations with (k, c), which
/// differ in the cage angle.
double misfit(const std::vector<double>& signal, const DynamicParameters& truth) {
  bearing::DynamicsOptions options;
  options.stiffness_n_per_m = truth.stiffness_n_per_m;
  options.damping_ns_per_m = truth.damping_ns_per_m;
  const auto left_by = [&](double cage_angle_rad) {
    const bearing::Motion motion{.shaft_speed_rpm = 1797, .cage_angle_rad = cage_angle_rad};
    const auto expected =
        bearing::simulate({}, {Defect::outer, 0.5334}, motion, options, {12000, signal.size()});
    std::vector<double> difference;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      difference.push_back(expected[i] - signal[i]);
    }
    return power(difference) / power(signal);
  };
  const double sample_rad = bearing::speeds({}, 1797).cage / 12000;  // a ball passes every 112
  int nearest = 0;
  double least = INFINITY;
  for (int i = 0; i < 112; ++i) {
    const double left = left_by(i * sample_rad);
    if (left < least) nearest = i;
    least = std::min(least, left);
  }
  for (int i = -8; i <= 8; ++i) least = std::min(least, left_by((nearest + i / 8.0) * sample_rad));
  return least;
}

TEST_F(SimulationTest, SimulatesTheStoredParameters) {
  const std::string short_and_steady =
      replaced(replaced(replaced(description, "speed_spread = 0.001", "speed_spread = 0"),
                        "slip_max = 0.01", "slip_max = 0"),
               "record_s = 0.2", "record_s = 0.03");
  const Recordings r = simulate(read(short_and_steady));
  const Record& record = r.records.back();  // outer defect: only the cage angle is not stored
  DynamicParameters truth = *record.parameters;
  EXPECT_LT(misfit(record.signal, truth), 0.02);
  truth.stiffness_n_per_m *= 1.1;
  EXPECT_GT(misfit(record.signal, truth), 0.2);
}

TEST_F(SimulationTest, IsEqualOnAnyNumberOfThreads) {
  const Simulation s = read(description + "snr_db = 10\n");
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const Recordings one = simulate(s);
  omp_set_num_threads(2);
  const Recordings two = simulate(s);
  omp_set_num_threads(threads);
  ASSERT_EQ(one.records.size(), two.records.size());
  for (std::size_t i = 0; i < one.records.size(); ++i) {
    EXPECT_EQ(one.records[i].name, two.records[i].name);
    EXPECT_EQ(one.records[i].signal, two.records[i].signal);
  }
}

TEST_F(SimulationTest, DrawsARecordFromItsNameAndTheSeed) {
  const Recordings four = simulate(read(description));
  const Recordings two = simulate(read(replaced(description, "_class = 4", "_class = 2")));
  EXPECT_EQ(four.records[0].signal, two.records[0].signal);
  EXPECT_EQ(four.records[4].name, two.records[2].name);
  EXPECT_EQ(four.records[4].signal, two.records[2].signal);
  const Recordings other = simulate(read(replaced(description, "seed = 0", "seed = 1")));
  EXPECT_NE(four.records[0].signal, other.records[0].signal);
}

TEST_F(SimulationTest, AddsNoiseRelativeToTheFaintestFault) {
  const Recordings clean = simulate(read(description));
  const Recordings noisy = simulate(read(description + "snr_db = 10\n"));
  const double expected = mean_power(clean, 2) / 10;  // B007 is weaker than OR021
  ASSERT_LT(mean_power(clean, 2), mean_power(clean, 1));
  for (std::size_t i = 0; i < clean.records.size(); ++i) {
    std::vector<double> noise;
    for (std::size_t j = 0; j < clean.records[i].signal.size(); ++j) {
      noise.push_back(noisy.records[i].signal[j] - clean.records[i].signal[j]);
    }
    EXPECT_NEAR(power(noise) / expected, 1, 0.15) << clean.records[i].name;  // 5 standard errors
  }
}

TEST_F(SimulationTest, ReportsItsProgress) {
  std::size_t calls = 0;
  std::size_t last = 0;
  (void)simulate(read(description), [&](std::size_t done) {
    ++calls;
    last = done;
  });
  EXPECT_EQ(calls, 12U);
  EXPECT_EQ(last, 12U);
}

TEST_F(SimulationTest, ReportsDivergenceInAParallelLoop) {
  Simulation s = read(description);
  s.dynamics.damping_ns_per_m = 1e7;
  EXPECT_THROW((void)simulate(s), Error);
}

TEST_F(SimulationTest, NamesUnknownAndMissingKeysWithTheirLine) {
  EXPECT_THAT(refusal(description + "noise = 3\n"), HasSubstr("small.toml, line 35"));
  EXPECT_THAT(refusal(description + "noise = 3\n"), HasSubstr("simulation.noise is unknown"));
  EXPECT_THAT(refusal(replaced(description, "load_n = 1000\n", "")),
              HasSubstr("simulation.load_n is missing"));
  EXPECT_THAT(refusal(simulated_head + faulty), HasSubstr("simulation is missing"));
  EXPECT_THAT(refusal(replaced(description, "sample_rate_hz = 12000\n", "")),
              HasSubstr("sample_rate_hz is missing"));
  EXPECT_THAT(refusal(replaced(description, "seed = 0", "seed = 0.5")),
              HasSubstr("simulation.seed must be a whole number"));
  EXPECT_THAT(refusal(replaced(description, "defect = \"none\"", "defect = \"none\"\ncolor = 1")),
              HasSubstr("color is unknown"));
}

TEST_F(SimulationTest, NamesImpossibleValuesWithTheirKey) {
  const auto with = [](const std::string& what, const std::string& by) {
    return replaced(description, what, by);
  };
  EXPECT_THAT(refusal(with("load_n = 1000", "load_n = 260")),
              HasSubstr("simulation.load_n must exceed 260 N"));  // 1.3e8 N/m * 2 um
  EXPECT_EQ(refusal(with("load_n = 1000", "load_n = 261")), "no error");
  EXPECT_THAT(refusal(with("seed = 0", "seed = -1")), HasSubstr("simulation.seed must be"));
  EXPECT_THAT(refusal(with("_class = 4", "_class = 0")), HasSubstr("records_per_class must be"));
  EXPECT_THAT(refusal(with("record_s = 0.2", "record_s = 1e-5")), HasSubstr("record_s must"));
  EXPECT_THAT(refusal(with("mass_kg = 1.0", "mass_kg = 0")), HasSubstr("mass_kg must be"));
  EXPECT_THAT(refusal(with("mass_kg = 1.0", "mass_kg = nan")), HasSubstr("mass_kg must be"));
  EXPECT_THAT(refusal(with("stiffness_spread = 0.1", "stiffness_spread = 0.34")),
              HasSubstr("stiffness_spread must be"));
  EXPECT_THAT(refusal(with("damping_spread = 0.2", "damping_spread = -0.1")),
              HasSubstr("damping_spread must be"));
  EXPECT_THAT(refusal(with("slip_max = 0.01", "slip_max = 1")), HasSubstr("slip_max must be"));
  EXPECT_THAT(refusal(with("balls = 9", "balls = 19")), HasSubstr("bearing is refused: bearing: "));
  EXPECT_THAT(refusal(with("= 0.5334", "= 8")), HasSubstr("class.defect_size_mm is refused"));
  EXPECT_THAT(refusal(simulated_head + table + "snr_db = 10\n"),
              HasSubstr("needs a faulty [[class]]"));
  EXPECT_EQ(refusal(simulated_head + table), "no error");
}

TEST_F(SimulationTest, ReportsAMissingFile) {
  try {
    (void)read_simulation("nowhere.toml");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::input_missing);
    EXPECT_THAT(error.what(), HasSubstr("nowhere.toml"));
  }
}

const std::string at_two_speeds =
    "[[simulation.condition]]\nname = \"900 rpm\"\nshaft_speed_rpm = 900\n"
    "[[simulation.condition]]\nname = \"1200 rpm\"\nshaft_speed_rpm = 1200\n";

TEST_F(SimulationTest, SimulatesAllRecordsInEachCondition) {
  const Simulation simulation = read(description + at_two_speeds +
                                     "[transfer]\nknown = [\"900 rpm\"]\ntest = [\"1200 rpm\"]\n");
  EXPECT_EQ(simulation.records(), 24U);
  const Recordings made = simulate(simulation);
  ASSERT_EQ(made.records.size(), 24U);
  ASSERT_EQ(made.info.conditions.size(), 2U);
  EXPECT_TRUE(made.info.conditions[0].known && !made.info.conditions[0].test);
  EXPECT_EQ(made.records.front().name, "B007-1200-rpm-01");
  std::set<std::string> names;
  for (const Record& record : made.records) {
    names.insert(record.name);
    const double nominal = record.condition == 0 ? 900 : 1200;
    EXPECT_NEAR(record.shaft_speed_rpm, nominal, 0.01 * nominal) << record.name;
  }
  EXPECT_EQ(names.size(), 24U);
}

/// Without noise, because its level depends on all records.
TEST_F(SimulationTest, SimulatesEachConditionIndependently) {
  const std::string alone =
      "[[simulation.condition]]\nname = \"1200 rpm\"\nshaft_speed_rpm = 1200\n";
  const Recordings one = simulate(read(description + alone));
  const Recordings both = simulate(read(description + at_two_speeds));
  EXPECT_EQ(both.records.size(), 2 * one.records.size());
  for (const Record& record : one.records) {
    const auto same = std::ranges::find(both.records, record.name, &Record::name);
    ASSERT_NE(same, both.records.end());
    EXPECT_EQ(record.signal, same->signal) << record.name;
  }
}

TEST_F(SimulationTest, RefusesInvalidConditions) {
  EXPECT_THAT(refusal(description + replaced(at_two_speeds, "1200 rpm", "900 rpm")),
              HasSubstr("condition.name '900 rpm' is given twice"));
  EXPECT_THAT(refusal(description + replaced(at_two_speeds, "= 1200", "= 0")),
              HasSubstr("condition.shaft_speed_rpm must be from 0.01"));
  EXPECT_THAT(refusal(description + at_two_speeds +
                      "[transfer]\nknown = [\"900 rpm\"]\ntest = [\"600 rpm\"]\n"),
              HasSubstr("transfer.test names '600 rpm'"));
}

}  // namespace
}  // namespace piae::signal
