#include <gtest/gtest.h>

#include <algorithm>

#include "artefact/reader.hpp"
#include "stages/tiny.hpp"

/// A split without known fault windows, and the stages that work with it.
namespace piae::stages {
namespace {

const Arguments train_of_nothing{"--method", "oracle", "--known", "C.h5",     "--real",
                                 "D.h5",     "--seed", "0",       "--output", "oracle.h5"};
const Arguments generate_of_nothing{"--model", "oracle.h5", "--count",  "25",
                                    "--seed",  "0",         "--output", "oracle_E.h5"};
const std::string no_window = "C.h5: has no known fault windows (known-per-class = 0), ";

/// Returns the arguments of a step, with the windows of oracle instead of others.
Arguments of_oracle(const std::string& stage, const std::string& output) {
  return with(with(step_of(stage).arguments, "--generated", "oracle_E.h5"), "--output", output);
}

class NothingKnown : public testing::Test {
 protected:
  void SetUp() override {
    tiny_.run_chain_before("split");
    Arguments split = with(step_of("split").arguments, "--known-per-class", "0");
    run_well("split", with(split, "--windows-per-class", "35"));
  }

  Outcome run_well(const std::string& stage, const Arguments& arguments) const {
    Outcome outcome = tiny_.run(stage, arguments);
    EXPECT_EQ(outcome.status, 0) << stage << ": " << outcome.err;
    return outcome;
  }
  void make_windows() const {
    run_well("train", train_of_nothing);
    run_well("generate", generate_of_nothing);
  }
  /// Returns the arguments without generated windows.
  [[nodiscard]] static Arguments of_none() {
    Arguments arguments = with(of_oracle("diagnose", "cell.h5"), "--ratio", "100to1");
    const auto generated = std::ranges::find(arguments, "--generated");
    arguments.erase(generated, generated + 2);
    return arguments;
  }

  const Tiny tiny_;
};

TEST_F(NothingKnown, SplitReportsItAndIsComplete) {
  const Outcome outcome =
      run_well("split", with(with(step_of("split").arguments, "--known-per-class", "0"),
                             "--windows-per-class", "35"));
  EXPECT_NE(outcome.out.find("split: A 30 B 25 C 0 D 50 windows"), std::string::npos);
  EXPECT_NE(outcome.out.find(
                "no fault windows are known (known-per-class = 0), so C.h5 is empty\nsplit: A 30 "),
            std::string::npos)
      << outcome.out;
  run_well("verify", {"A.h5", "B.h5", "C.h5", "D.h5"});
  expect_refusal(tiny_.run("split", with(step_of("split").arguments, "--test-per-class", "0")),
                 "split", 2, {"--test-per-class"});
}

TEST_F(NothingKnown, MethodsThatLearnFromKnownWindowsAreRefused) {
  for (const std::string method : {"smote", "piae-dt", "strike-twin", "shift"}) {
    expect_refusal(tiny_.run("train", {"--method", method, "--known", "C.h5", "--seed", "0",
                                       "--output", "model.h5"}),
                   "train", 65,
                   {no_window + "but " + method + " learns from them; use a method that does not: ",
                    "oracle"});
  }
  EXPECT_FALSE(fs::exists(tiny_ / "model.h5"));
}

TEST_F(NothingKnown, OracleWorksThroughAllStages) {
  make_windows();
  run_well("score", of_oracle("score", "score.h5"));
  run_well("diagnose", of_oracle("diagnose", "cell.h5"));
  run_well("diagnose", with(of_oracle("diagnose", "near.h5"), "--classifier", "nearest"));
  run_well("verify", {"C.h5", "oracle.h5", "oracle_E.h5", "score.h5", "cell.h5", "near.h5"});
  const artefact::Reader cell(tiny_ / "cell.h5", "diagnosis");
  EXPECT_EQ(cell.integer("/", "known_per_class"), 0);
  EXPECT_EQ(cell.real("/", "true_ratio"), 25.0 / 5);
}

TEST_F(NothingKnown, ClassifiersNeedAFaultWindow) {
  for (const std::string classifier : {"wdcnn", "nearest"}) {
    expect_refusal(tiny_.run("diagnose", with(of_none(), "--classifier", classifier)), "diagnose",
                   65, {no_window + "and " + classifier + " cannot learn faults without any"});
  }
  EXPECT_FALSE(fs::exists(tiny_ / "cell.h5"));
  expect_refusal(tiny_.run("diagnose", with(of_none(), "--classifier", "symptom-net")), "diagnose",
                 65, {"or a rule by --classifier: envelope-rule, exclusion-rule"});
}

TEST_F(NothingKnown, RulesDoNotNeedFaultWindows) {
  for (const std::string rule : {"envelope-rule", "exclusion-rule"}) {
    const Outcome outcome =
        run_well("diagnose", with(with(of_none(), "--classifier", rule), "--output", "rule.h5"));
    EXPECT_NE(outcome.out.find("by comparison with 25 healthy windows (none 100to1, " + rule),
              std::string::npos)
        << outcome.out;
    run_well("verify", {"rule.h5"});
  }
}

TEST_F(NothingKnown, TablesReportIt) {
  make_windows();
  run_well("diagnose", of_oracle("diagnose", "run/tiny/seed0/oracle/50to1/wdcnn/diagnosis.h5"));
  Arguments tabulate{"--run",    "run",          "--dataset",
                     "tiny",     "--methods",    "none,oracle",
                     "--ratios", "100to1,50to1", "--seeds",
                     "0",        "--published",  std::string(PIAE_SOURCE) + "/results/published"};
  EXPECT_EQ(tiny_.run("tabulate", tabulate).status, 66);  // none by wdcnn
  run_well("tabulate", with(tabulate, "--nothing-known", "tiny"));
  for (const std::string file : {"tables.md", "summary.txt"}) {
    EXPECT_NE(bytes_of(tiny_ / "run/tiny" / file).find("No fault window was known."),
              std::string::npos)
        << file;
  }
  run_well("figures", {"--run", "run", "--dataset", "tiny", "--published",
                       std::string(PIAE_SOURCE) + "/results/published"});
  run_well("report",
           {"--run", "run", "--published", std::string(PIAE_SOURCE) + "/results/published",
            "--style", std::string(PIAE_SOURCE) + "/pipeline/report"});
  EXPECT_NE(bytes_of(tiny_ / "run/report.md").find("No fault window was known."),
            std::string::npos);
}

}  // namespace
}  // namespace piae::stages
