// Builds and uses CONTRIBUTING.md's examples of a data set, method, classifier, table, figure and
// stage, letter for letter (contributing/lay_out.sh).

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "artefact/reader.hpp"
#include "base/random.hpp"
#include "signal/window_set.hpp"
#include "stages/tiny.hpp"

namespace piae::stages {
namespace {

using testing::HasSubstr;

/// Returns a program built from the examples.
std::string shown(const std::string& stage) {
  return fs::relative(fs::path(PIAE_SHOWN) / "bin" / stage, PIAE_BIN);
}

/// Returns 6 s at 12 kHz: a decaying oscillation of amplitude `level` every 80 samples, and some
/// noise.
std::string recording(double level) {
  Stream noise("recording");
  std::string text;
  for (int i = 0; i < 72000; ++i) {
    const double since_impact = i % 80;
    text += std::to_string(level * std::exp(-since_impact / 12) * std::sin(since_impact) +
                           noise.normal(0, 0.1)) +
            '\n';
  }
  return text;
}

TEST(ShownDataSet, IsCheckedIngestedAndSplit) {
  const Folder folder;
  const std::string description = std::string(PIAE_SHOWN) + "/pipeline/datasets/rig.toml";
  folder.write("data/rig/healthy.csv", recording(0.2));
  folder.write("data/rig/outer.csv", recording(1));
  const Outcome checked =
      run(folder.path(), "ingest", {"--check", "--description", description, "--data-dir", "data"});
  EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
  EXPECT_THAT(checked.out, HasSubstr("rig/outer.csv"));
  const Outcome ingested =
      run(folder.path(), "ingest",
          {"--description", description, "--data-dir", "data", "--output", "records.h5"});
  EXPECT_EQ(ingested.out, "ingest: 2 records, 144000 samples at 12000 Hz\n") << ingested.err;
  const Outcome split =
      run(folder.path(), "split", {"--records", "records.h5", "--seed", "0", "--output-dir", "."});
  EXPECT_EQ(split.status, 0) << split.err;
}

TEST(ShownDataSet, NamesTheMissingRecording) {
  const Folder folder;
  folder.write("data/rig/healthy.csv", recording(0.2));
  const Outcome checked =
      run(folder.path(), "ingest",
          {"--check", "--description", std::string(PIAE_SHOWN) + "/pipeline/datasets/rig.toml",
           "--data-dir", "data"});
  EXPECT_EQ(checked.status, 66);
  EXPECT_THAT(checked.out, HasSubstr("rig/outer.csv"));
}

TEST(ShownClassifier, IsTrainedOnItsInput) {
  const Tiny tiny;
  tiny.run_chain_before("diagnose");
  const Outcome diagnosed = tiny.run(
      shown("diagnose"), with(step_of("diagnose").arguments, "--classifier", "wdcnn-magnitude"));
  ASSERT_EQ(diagnosed.status, 0) << diagnosed.err;
  EXPECT_THAT(diagnosed.out, HasSubstr("(piae-dt 50to1, wdcnn-magnitude, seed 0): accuracy"));
}

TEST(ShownMethod, PlaysTheKnownWindowsBackwards) {
  const Tiny tiny;
  tiny.run_chain_before("train");
  const Outcome trained = tiny.run(shown("train"), {"--method", "reverse", "--known", "C.h5",
                                                    "--seed", "0", "--output", "model.h5"});
  EXPECT_EQ(trained.out, "trained reverse on 10 windows of 2 fault classes: model.h5\n")
      << trained.err;
  const Outcome generated = tiny.run(shown("generate"), {"--model", "model.h5", "--count", "7",
                                                         "--seed", "0", "--output", "E.h5"});
  ASSERT_EQ(generated.status, 0) << generated.err;
  const auto read = [&](const std::string& file) {
    return signal::read_window_set(artefact::Reader(tiny / file, "windows"));
  };
  const signal::WindowSet known = read("C.h5");
  const signal::WindowSet backwards = read("E.h5");
  ASSERT_EQ(backwards.size(), 14U);
  for (std::size_t i = 0; i < backwards.size(); ++i) {
    const std::vector<std::size_t> own = known.indices_of(backwards.labels[i]);
    const auto window = known.window(own[i % 7 % own.size()]);
    EXPECT_TRUE(std::equal(window.rbegin(), window.rend(), backwards.window(i).begin())) << i;
  }
}

TEST(ShownMethod, IsListedInTheHelp) {
  const Tiny tiny;
  EXPECT_THAT(tiny.run(shown("train"), {"--help"}).out, HasSubstr("reverse"));
}

/// Returns the mean accuracy in a line of accuracy.csv, cut to two decimals.
std::string accuracy_of(const std::string& csv, const std::string& cell) {
  std::istringstream fields(csv.substr(csv.find("\n" + cell) + 1));
  std::string field;
  for (int column = 0; column < 7; ++column) std::getline(fields, field, ',');
  return field.substr(0, field.find('.') + 3);
}

// Uses one seed, so the lowest accuracy is also the highest.
TEST(ShownTable, HasTheLowestAndTheHighestAccuracyOfEachCell) {
  const Tiny tiny;
  tiny.run_chain_before("tabulate");
  const Outcome outcome = tiny.run(shown("tabulate"), step_of("tabulate").arguments);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string csv = bytes_of(tiny / "run/tiny/accuracy.csv");
  const std::string none = accuracy_of(csv, "tiny,none,wdcnn,100to1,");
  const std::string piae_dt = accuracy_of(csv, "tiny,piae-dt,wdcnn,50to1,");
  EXPECT_THAT(bytes_of(tiny / "run/tiny/tables.md"),
              testing::ContainsRegex("\n## Lowest and highest accuracy among the seeds, percent\n\n"
                                     "\\| method  \\| ratio [^\n]*\n[^\n]*\n"
                                     "\\| none    \\| [^\n]*\\| +" +
                                     none + " \\| +" + none +
                                     " \\|\n"
                                     "\\| piae-dt \\| [^\n]*\\| +" +
                                     piae_dt + " \\| +" + piae_dt + " \\|\n"));
  EXPECT_THAT(bytes_of(tiny / "run/tiny/tables.tex"), HasSubstr("{tab:tiny-seed-range}"));
}

// With one seed the lowest accuracy is the mean.
TEST(ShownColumn, IsInEveryTableOfAccuracies) {
  const Tiny tiny;
  tiny.run_chain_before("tabulate");
  const Outcome outcome = tiny.run(shown("tabulate"), step_of("tabulate").arguments);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string csv = bytes_of(tiny / "run/tiny/accuracy.csv");
  EXPECT_THAT(csv, HasSubstr(",published,lowest\n"));
  const std::string piae_dt = accuracy_of(csv, "tiny,piae-dt,wdcnn,50to1,");
  EXPECT_THAT(csv,
              testing::ContainsRegex("\ntiny,piae-dt,wdcnn,50to1,[^\n]*," + piae_dt + "[0-9]+\n"));
  EXPECT_THAT(bytes_of(tiny / "run/tiny/gains.csv"), HasSubstr(",published,lowest\n"));
  EXPECT_THAT(outcome.out, testing::ContainsRegex("^method [^\n]* lowest\n"));
  for (const char* file : {"run/tiny/tables.md", "run/tiny/tables.tex"}) {
    EXPECT_THAT(bytes_of(tiny / file),
                testing::ContainsRegex("method *[|&] ratio *[|&][^\n]* lowest "));
  }
}

TEST(ShownFigure, HasTheRangeOfEachCell) {
  const Tiny tiny;
  tiny.run_chain_before("tabulate");
  const Outcome tabulated = tiny.run("tabulate", step_of("tabulate").arguments);
  ASSERT_EQ(tabulated.status, 0) << tabulated.err;
  const Outcome outcome =
      tiny.run(shown("figures"), {"--run", "run", "--dataset", "tiny", "--published",
                                  std::string(PIAE_SOURCE) + "/results/published"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string none =
      accuracy_of(bytes_of(tiny / "run/tiny/accuracy.csv"), "tiny,none,wdcnn,100to1,");
  EXPECT_THAT(bytes_of(tiny / "run/tiny/figures/seed-range.csv"),
              HasSubstr("\nnone,100to1," + none.substr(0, 4)));
}

TEST(ShownStage, CountsTheWindowsOfEachClass) {
  const Tiny tiny;
  tiny.run_chain_before("train");
  const Outcome counted = tiny.run(shown("count"), {"--windows", "C.h5", "--output", "counts.csv"});
  EXPECT_EQ(counted.out, "count: 10 windows: counts.csv\n") << counted.err;
  EXPECT_EQ(bytes_of(tiny / "counts.csv"), "class,windows\nNormal,0\nIR007,5\nOR021,5\n");
  EXPECT_THAT(tiny.run(shown("count"), {"--help"}).out, HasSubstr("count --windows seed0/C.h5"));
}

TEST(ShownStage, RefusesAFileThatItCannotCount) {
  const Tiny tiny;
  tiny.run_chain_before("split");
  const auto refused = [&](const std::string& windows, int exit,
                           const std::vector<std::string>& words) {
    expect_refusal(tiny.run(shown("count"), {"--windows", windows, "--output", "c.csv"}), "count",
                   exit, words);
  };
  refused("no.h5", 66, {"no.h5"});
  refused("records.h5", 65, {"records.h5", "windows"});
  expect_refusal(tiny.run(shown("count"), {}), "count", 2, {"--windows"});
}

}  // namespace
}  // namespace piae::stages
