#include "regression/deviations.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include "base/error.hpp"
#include "regression/run_measurements.hpp"
#include "regression/deviations_text.hpp"
#include "report/run.hpp"

namespace piae::report {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Accuracies of one method at 10to1, of seeds 0, 1, ...
void add(Measurements& side, const std::string& method, const std::vector<double>& values) {
  for (std::size_t seed = 0; seed < values.size(); ++seed) {
    side.values.push_back(
        {method, "10to1", "accuracy", static_cast<std::int64_t>(seed), values[seed]});
  }
}

Measurements side(const std::vector<double>& values, const std::string& settings = "this machine") {
  Measurements measurements{"cwru", "random", {}, {"0.1.0"}, {settings}};
  add(measurements, "vae", values);
  return measurements;
}

ComparedRow only_row(const std::vector<double>& reference, const std::vector<double>& run,
                     Tolerance tolerance) {
  const Comparison comparison = compare(side(reference), side(run), {}, tolerance);
  EXPECT_THAT(comparison.missing, IsEmpty());
  EXPECT_THAT(comparison.not_in_reference, IsEmpty());
  EXPECT_EQ(comparison.rows.size(), 1U);
  EXPECT_EQ(comparison.passed(), comparison.rows.front().within);
  return comparison.rows.front();
}

/// `steps` representable numbers above `value`.
double above(double value, int steps) {
  for (int i = 0; i < steps; ++i) value = std::nextafter(value, 1e9);
  return value;
}

/// Squares about the mean: 0.004 (4 degrees of freedom) and 0.0008 (1): variance 0.0048 / 5. The
/// standard error of the difference of two means of 2 is sqrt(0.00096 (1/2 + 1/2)). 5.51: the
/// Guide to the Expression of Uncertainty in Measurement, Table G.2, 99.73 %.
TEST(Comparison, OfTwoSeedsUsesTheSpreadOfAllThatAreStored) {
  const Comparison comparison = compare(side({0.60, 0.62, 0.64, 0.66, 0.68}), side({0.60, 0.64}),
                                        {{}, {}, {}, {0, 1}}, Tolerance::spread);
  EXPECT_TRUE(comparison.passed());
  ASSERT_EQ(comparison.rows.size(), 1U);
  const ComparedRow& row = comparison.rows.front();
  EXPECT_EQ(row.seeds, 2U);
  EXPECT_EQ(row.moved_seeds, 1U);
  EXPECT_DOUBLE_EQ(row.reference, 0.61);
  EXPECT_DOUBLE_EQ(row.run, 0.62);
  EXPECT_NEAR(*row.standard_error, 0.030983867, 1e-9);
  EXPECT_NEAR(*row.standard_errors(), 0.32274861, 1e-8);
  EXPECT_NEAR(row.allowed, 5.51, 0.005);
}

/// Squares 10 and 10 with 8 degrees of freedom: variance 2.5, standard error sqrt(2.5 * 2 / 5) = 1.
/// 4.28: the same table.
TEST(Comparison, EndsAtAsManyStandardErrorsAsChanceMayExplain) {
  const auto shifted_by = [](double shift) {
    return only_row({1, 2, 3, 4, 5}, {1 + shift, 2 + shift, 3 + shift, 4 + shift, 5 + shift},
                    Tolerance::spread);
  };
  EXPECT_NEAR(*shifted_by(1).standard_errors(), 1, 1e-12);
  EXPECT_NEAR(*shifted_by(-1).standard_errors(), -1, 1e-12);
  EXPECT_NEAR(shifted_by(1).allowed, 4.28, 0.005);
  EXPECT_TRUE(shifted_by(4.27).within);
  EXPECT_TRUE(shifted_by(-4.27).within);
  EXPECT_FALSE(shifted_by(4.29).within);
  EXPECT_FALSE(shifted_by(-4.29).within);
}

/// Of few seeds. Squares of `vae`: none (2 degrees of freedom); of `ae`: 2 + 2 (2). Together
/// variance 4 / 4 = 1, that of `ae` alone 2. 6.62: the same table.
TEST(Comparison, OfFewSeedsBorrowsTheSpreadOfTheOtherRows) {
  Measurements reference = side({10, 10});
  Measurements run = side({11, 11});
  add(reference, "ae", {1, 3});
  add(run, "ae", {2, 4});
  const Comparison comparison = compare(reference, run, {}, Tolerance::spread);
  ASSERT_EQ(comparison.rows.size(), 2U);
  EXPECT_NEAR(*comparison.rows[0].standard_error, 1, 1e-12);
  EXPECT_NEAR(*comparison.rows[1].standard_error, std::sqrt(2), 1e-12);
  EXPECT_NEAR(comparison.rows[0].allowed, 6.62, 0.005);
  EXPECT_NEAR(comparison.rows[1].allowed, 6.62, 0.005);
  EXPECT_TRUE(comparison.passed());
}

TEST(Comparison, OfManySeedsKeepsItsOwnSpread) {
  Measurements reference = side({1, 2, 3, 4, 5});
  Measurements run = side({1, 2, 3, 4, 5});
  add(reference, "ae", {0, 1000});
  add(run, "ae", {0, 1000});
  const Comparison comparison = compare(reference, run, {}, Tolerance::spread);
  EXPECT_NEAR(*comparison.rows.front().standard_error, 1, 1e-12);
}

TEST(Comparison, OfOneSeedAllowsNoChange) {
  EXPECT_TRUE(only_row({0.5}, {0.5}, Tolerance::spread).within);
  const ComparedRow moved = only_row({0.5}, {0.501}, Tolerance::spread);
  EXPECT_FALSE(moved.within);
  EXPECT_FALSE(moved.standard_errors());
}

TEST(Comparison, WithoutScatterAllowsNoChange) {
  EXPECT_TRUE(only_row({1, 1, 1}, {1, 1, 1}, Tolerance::spread).within);
  const ComparedRow moved = only_row({1, 1, 1}, {0.99, 0.99, 0.99}, Tolerance::spread);
  EXPECT_FALSE(moved.within);
}

TEST(Comparison, IsExactToFourUnitsInTheLastPlace) {
  EXPECT_TRUE(only_row({0.5, 0.7}, {above(0.5, 4), 0.7}, Tolerance::exact).within);
  const ComparedRow moved = only_row({0.5, 0.7}, {above(0.5, 5), 0.7}, Tolerance::exact);
  EXPECT_FALSE(moved.within);
  EXPECT_EQ(moved.moved_seeds, 1U);
  EXPECT_TRUE(only_row({0.5, 0.7}, {above(0.5, 5), 0.7}, Tolerance::spread).within);
}

/// The means agree, and yet not one seed does.
TEST(Comparison, IsExactSeedBySeed) {
  EXPECT_FALSE(only_row({0.5, 0.7}, {0.7, 0.5}, Tolerance::exact).within);
}

TEST(Comparison, IsExactOnlyWhereBothSidesHaveOneAndTheSameSettings) {
  const Measurements here = side({1});
  EXPECT_EQ(tolerance_for(here, side({1})), Tolerance::exact);
  EXPECT_EQ(tolerance_for(here, side({1}, "another machine")), Tolerance::spread);
  Measurements mixed = side({1});
  mixed.settings.insert("another machine");
  EXPECT_EQ(tolerance_for(mixed, mixed), Tolerance::spread);
}

TEST(Comparison, NamesCellsOfOneSideOnly) {
  Measurements reference = side({1, 2, 3});
  Measurements run = side({1});
  add(reference, "ae", {1});
  add(run, "smote", {1, 2});
  for (const char* metric : {"mmd", "rmse"}) {
    reference.values.push_back({"ae", "", metric, 7, 0.5});
  }
  const Comparison comparison = compare(reference, run, {}, Tolerance::exact);
  EXPECT_THAT(comparison.missing,
              ElementsAre("vae 10to1, seeds 1 2", "ae 10to1, seed 0", "ae score, seed 7"));
  EXPECT_THAT(comparison.not_in_reference, ElementsAre("smote 10to1, seeds 0 1"));
  EXPECT_FALSE(comparison.passed());
  EXPECT_TRUE(compare(reference, run, {{}, {"vae"}, {}, {0}}, Tolerance::exact).passed());
}

TEST(Comparison, NeedsOneDatasetAndProtocol) {
  Measurements other = side({1});
  other.protocol = "blocked";
  EXPECT_THROW(compare(side({1}), other, {}, Tolerance::exact), std::logic_error);
}

TEST(Comparison, ShowsWhatMoved) {
  Measurements reference = side({0.60, 0.62, 0.64, 0.66, 0.68});
  Measurements run = side({0.70, 0.62, 0.64, 0.66, 0.68}, "another machine");
  add(reference, "ae", {0.5, 0.7});
  add(run, "ae", {0.5, 0.7});
  add(reference, "smote", {0.5});
  const Comparison comparison = compare(reference, run, {}, Tolerance::exact);
  // Squares 0.004 and 0.0004 * 2 + 0.0016 * 2 = 0.004, 8 degrees of freedom: variance 0.001,
  // standard error 0.02.
  EXPECT_EQ(
      comparison_text(reference, run, Tolerance::exact, comparison),
      "cwru, protocol random\n"
      "  reference  0.1.0; this machine\n"
      "  run        0.1.0; another machine\n"
      "  tolerance  exact: every seed must give the same number\n"
      "method  ratio  quantity           seeds  moved  reference   run  difference  std errors  "
      "allowed\n"
      "vae     10to1  accuracy  OUTSIDE      5      1       0.64  0.66       +0.02       +1.00     "
      "4.28\n"
      "missing in the run: smote 10to1, seed 0\n"
      "compared 2 quantities of cwru: 1 moved, 1 outside the tolerance\n");
}

TEST(Selection, ScoresGoWithRatiosThatHaveGeneratedWindows) {
  EXPECT_TRUE(Selection{}.has("vae", "", 0));
  const Selection baseline{{}, {}, {"100to1"}, {}};
  EXPECT_FALSE(baseline.has("vae", "", 0));
  EXPECT_TRUE(baseline.has("none", "100to1", 0));
  EXPECT_FALSE(baseline.has("vae", "10to1", 0));
  const Selection both{{}, {}, {"100to1", "10to1"}, {}};
  EXPECT_TRUE(both.has("vae", "", 0));
  EXPECT_THROW((void)(Selection{{}, {}, {"3to1"}, {}}.has("vae", "", 0)), Error);
}

class Stored : public Run {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_.path() / "random"); }
  void store(const std::string& text) const { write_text("random/cwru.csv", text); }
  [[nodiscard]] Measurements read() const {
    return read_reference(folder_.path(), "random", "cwru");
  }
  void expect_refused(const std::string& text, const std::string& what, Exit exit) const {
    store(text);
    try {
      (void)read();
      ADD_FAILURE() << "not refused: " << what;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("random/cwru.csv"));
      EXPECT_THAT(error.what(), HasSubstr(what));
      EXPECT_EQ(error.exit(), exit);
    }
  }
};

TEST_F(Stored, ReferenceComesBackToTheLastDigit) {
  Measurements written = side({0.1 + 0.2, 1.0 / 3, 1e-17, 0.62});
  written.values.push_back({"vae", "", "mmd", 100, 123456.789});
  written.versions = {"0.1.0 (abc)", "0.2.0"};
  written.settings = {"a; b", "c"};
  store(reference_csv(written));
  const Measurements back = read();
  EXPECT_EQ(back.versions, written.versions);
  EXPECT_EQ(back.settings, written.settings);
  ASSERT_EQ(back.values.size(), written.values.size());
  for (std::size_t i = 0; i < back.values.size(); ++i) {
    EXPECT_EQ(back.values[i].method, written.values[i].method);
    EXPECT_EQ(back.values[i].ratio, written.values[i].ratio);
    EXPECT_EQ(back.values[i].quantity, written.values[i].quantity);
    EXPECT_EQ(back.values[i].seed, written.values[i].seed);
    EXPECT_EQ(back.values[i].value, written.values[i].value);
  }
  EXPECT_THAT(reference_datasets(folder_.path(), "random"), ElementsAre("cwru"));
  EXPECT_THAT(reference_datasets(folder_.path(), "blocked"), IsEmpty());
}

TEST_F(Stored, ReferenceThatIsDamagedOrMissingIsRefused) {
  const std::string made = "# built from: 1\n# computed with: 2\n";
  const std::string header = "method,ratio,quantity,seed,value\n";
  const std::string line = "vae,10to1,accuracy,0,0.5\n";
  expect_refused(header + line, "does not say what it was made with", Exit::bad_input);
  expect_refused(made + "method,seed\nvae,0\n", "line 3: is not the header", Exit::bad_input);
  expect_refused(made + header, "holds no table", Exit::bad_input);
  expect_refused(made + header + line + line, "line 5: is there twice", Exit::bad_input);
  expect_refused(made + header + "vae,10to1,accuracy,-1,0.5\n", "'-1' is not a seed",
                 Exit::bad_input);
  expect_refused(made + header + "vae,10to1,accuracy,0.5,0.5\n", "'0.5' is not a seed",
                 Exit::bad_input);
  expect_refused(made + header + "vae,10to1,accuracy,0,nan\n", "'nan' is not a number",
                 Exit::bad_input);
  std::filesystem::remove(folder_.path() / "random/cwru.csv");
  try {
    (void)read();
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("`make reference RUN=...` makes one"));
    EXPECT_EQ(error.exit(), Exit::input_missing);
  }
}

/// The run of run.hpp; of two classes the metrics' means are (0.5 + 1e-7) / 2 and so on.
TEST_F(Run, IsReadWithWhatMadeIt) {
  add_all();
  const std::vector<Measurements> datasets = read_run(folder_.path() / "run", {});
  ASSERT_EQ(datasets.size(), 1U);
  const Measurements& run = datasets.front();
  EXPECT_EQ(run.dataset, "cwru");
  EXPECT_EQ(run.protocol, "random");
  EXPECT_THAT(run.versions, ElementsAre(artefact::build_version()));
  EXPECT_THAT(run.settings,
              ElementsAre(artefact::cpu_settings() + "; " + artefact::build_libraries()));
  std::string text;
  for (const Measured& each : run.values) {
    if (each.seed == 0) {
      text += each.method + ' ' + each.ratio + ' ' + each.quantity + ' ' +
              std::to_string(each.value) + '\n';
    }
  }
  EXPECT_EQ(text,
            "none 100to1 accuracy 0.600000\n"
            "vae 10to1 accuracy 0.750000\n"
            "vae 2to1 accuracy 0.850000\n"
            "vae  aligned_rmse 2.000000\n"
            "vae  amplitude_ratio 2.500000\n"
            "vae  fault_line_db 3.500000\n"
            "vae  fault_line_difference_db 4.000000\n"
            "vae  mmd 0.250000\n"
            "vae  rmse 1.000000\n"
            "vae  spectral_distance_db 3.000000\n");
}

TEST_F(Run, IsReadAsFarAsItIsSelected) {
  add_all();
  const auto run = folder_.path() / "run";
  EXPECT_EQ(read_run(run, {{}, {"vae"}, {"2to1"}, {1}}).front().values.size(), 8U);
  for (const Selection& nothing : {Selection{{"hit-sm"}, {}, {}, {}}, {{}, {}, {}, {9}}}) {
    try {
      (void)read_run(run, nothing);
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.exit(), Exit::input_missing);
      EXPECT_THAT(error.what(), HasSubstr("run: holds no diagnosis or score of those asked for"));
    }
  }
}

TEST_F(Run, WithACellThatCannotBeIsNotCompared) {
  add_all();
  const auto expect_refused = [&](const std::string& what) {
    try {
      (void)read_run(folder_.path() / "run", {});
      ADD_FAILURE() << "not refused: " << what;
    } catch (const Error& error) {
      EXPECT_EQ(error.exit(), Exit::bad_input);
      EXPECT_THAT(error.what(), HasSubstr(what));
    }
  };
  scoring::DiagnosisRecord other = diagnosis("vae", "2to1", 145, 1, 9);
  other.protocol = "blocked";
  add(other);
  expect_refused("seed1/vae/2to1/diagnosis.h5: the split protocol is blocked");
  save("diagnosis", diagnosis("ae", "2to1", 145, 1, 9), layout_.diagnosis("vae", "2to1", 1));
  expect_refused("the method is ae, here it must be vae");
  std::filesystem::resize_file(layout_.diagnosis("vae", "2to1", 1), 1000);
  expect_refused("seed1/vae/2to1/diagnosis.h5");
}

}  // namespace
}  // namespace piae::report
