#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stages/tiny.hpp"

namespace piae::stages {
namespace {

class Usage : public testing::TestWithParam<const char*> {};

TEST_P(Usage, HelpShowsAnExample) {
  const Folder folder;
  const Outcome help = run(folder.path(), GetParam(), {"--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.err, "");
  EXPECT_NE(help.out.find(std::string("Example:\n  ") + GetParam() + ' '), std::string::npos)
      << help.out;
}

TEST_P(Usage, VersionIsOneLineWithTheNumber) {
  const Folder folder;
  const Outcome version = run(folder.path(), GetParam(), {"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.err, "");
  EXPECT_THAT(version.out,
              testing::MatchesRegex("piae-dt " + std::string(GetParam()) +
                                    " [0-9]+[.][0-9]+[.][0-9]+( [(][0-9a-f]+(-changed)?[)])?\n"));
}

TEST_P(Usage, FailsWhenTheOutputCannotBeWritten) {
  const Folder folder;
  const std::string help = std::string(PIAE_BIN) + '/' + GetParam() + " --help >/dev/full 2>";
  const int status = std::system((help + (folder / "err").string()).c_str());
  EXPECT_EQ(WEXITSTATUS(status), 1);
  EXPECT_EQ(bytes_of(folder / "err"),
            std::string(GetParam()) +
                ": standard output: cannot be written completely; is the disk full?\n");
}

TEST_P(Usage, WithoutArgumentsIsAUsageError) {
  const Folder folder;
  expect_refusal(run(folder.path(), GetParam(), {}), GetParam(), 2, {"required", "--help"});
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST_P(Usage, UnknownOptionIsNamed) {
  const Tiny tiny;
  Arguments arguments{"some.h5"};
  if (GetParam() == std::string("ingest")) {
    arguments = {"--description", "tiny.toml", "--output", "x.h5"};
  } else if (GetParam() == std::string("sweep")) {
    arguments = {"--run",   "run",      "--dataset", "tiny",    "--points",
                 "batch=1", "--ratios", "50to1",     "--seeds", "0"};
  } else if (GetParam() == std::string("contrast")) {
    arguments = {"--with",   "run/tiny", "--without", "other/tiny", "--methods", "none",
                 "--ratios", "100to1",   "--seeds",   "0",          "--output",  "x.md"};
  } else if (GetParam() == std::string("transfer")) {
    arguments = {"--run",     "run",   "--group",       "a",     "--datasets", "tiny",
                 "--against", "none",  "--inputs",      "a=b",   "--methods",  "none",
                 "--ratio",   "50to1", "--classifiers", "wdcnn", "--seeds",    "0"};
  } else if (GetParam() == std::string("identify")) {
    arguments = {"--run", "run", "--dataset", "tiny", "--methods", "piae-dt", "--seeds", "0"};
  } else if (GetParam() == std::string("read_raw")) {
    arguments = {"--file", "tiny.csv", "--variable", "1"};
  } else if (GetParam() == std::string("export_windows")) {
    arguments = {"--windows", "E.h5", "--output", "E.csv"};
  } else if (GetParam() == std::string("monitor")) {
    arguments = {"--classifier", "c.h5", "--sample-rate-hz", "12000", "--speed-rpm", "1797"};
  } else if (GetParam() == std::string("teach")) {
    arguments = {"--output", "any-bearing.h5"};
  } else if (GetParam() == std::string("classify")) {
    arguments = {"--classifier", "c.h5"};
  } else if (GetParam() == std::string("trust") || GetParam() == std::string("verdicts")) {
    arguments = {"--run", "run",      "--dataset", "tiny",    "--methods",
                 "none",  "--ratios", "100to1",    "--seeds", "0"};
  } else if (GetParam() == std::string("check")) {
    arguments = {"--run", "run", "--reference", "reference"};
  } else if (GetParam() != std::string("verify")) {
    arguments = step_of(GetParam()).arguments;
  }
  arguments.emplace_back("--colour");
  expect_refusal(tiny.run(GetParam(), arguments), GetParam(), 2, {"--colour"});
  EXPECT_EQ(tiny.files(), std::set<std::string>{"tiny.toml"});
}

INSTANTIATE_TEST_SUITE_P(Stages, Usage,
                         testing::Values("ingest", "simulate", "split", "train", "generate",
                                         "score", "diagnose", "tabulate", "sweep", "check",
                                         "contrast", "transfer", "identify", "verify", "read_raw",
                                         "export_windows", "monitor", "classify", "teach", "trust",
                                         "verdicts"),
                         [](const auto& info) { return info.param; });

TEST(Usage, TrainHelpShowsTheOptionsOfTheMethod) {
  const Folder folder;
  const Outcome help = run(folder.path(), "train", {"--method", "piae-dt", "--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_NE(help.out.find("--learning-rate"), std::string::npos) << help.out;
}

/// piae-dt-phase always draws class by class.
TEST(Usage, TrainHelpShowsNoUnusedOption) {
  const Folder folder;
  for (const auto& [method, has_space] : {std::pair{"piae-dt", true}, {"piae-dt-phase", false}}) {
    const Outcome help = run(folder.path(), "train", {"--method", method, "--help"});
    EXPECT_EQ(help.out.find("--space ") != std::string::npos, has_space) << help.out;
  }
}

/// An option with an impossible value, and words of the error message.
struct ImpossibleValue {
  const char* stage;
  const char* option;
  const char* value;
  std::vector<std::string> words;
};

TEST(Usage, ImpossibleValuesAreNamedWithKnownOnes) {
  const std::vector<ImpossibleValue> cases{
      {"train", "--epochs", "0", {"--epochs"}},
      {"train", "--epochs", "many", {"--epochs", "many"}},
      {"train", "--keep", "worst", {"--keep", "best", "final"}},
      {"generate", "--count", "0", {"--count"}},
      {"split", "--seed", "first", {"--seed", "first"}},
      {"split", "--protocol", "fair", {"fair", "random", "blocked"}},
      {"split", "--window", "0", {"window"}},
      {"split", "--windows-per-class", "-40", {"--windows-per-class"}},
      {"split", "--test-per-class", "40", {"40"}},
      {"diagnose", "--ratio", "7to1", {"7to1", "100to1", "50to1", "10to1", "1to1"}},
      {"diagnose", "--batch", "1", {"--batch"}},
  };
  const Tiny tiny;
  tiny.run_chain_before("train");
  const std::set<std::string> before = tiny.files();
  for (const ImpossibleValue& c : cases) {
    SCOPED_TRACE(std::string(c.stage) + ' ' + c.option + ' ' + c.value);
    const Arguments arguments = with(step_of(c.stage).arguments, c.option, c.value);
    expect_refusal(tiny.run(c.stage, arguments), c.stage, 2, c.words);
  }
  EXPECT_EQ(tiny.files(), before);
}

TEST(Usage, UnknownMethodIsNamedWithKnownOnes) {
  const Tiny tiny;
  tiny.run_chain_before("train");
  expect_refusal(tiny.run("train", {"--method", "magic", "--known", "C.h5", "--seed", "0",
                                    "--output", "model.h5"}),
                 "train", 2, {"magic", "piae-dt"});
}

TEST(Usage, UnknownPartsOfTheGridAreNamed) {
  const Tiny tiny;
  const auto tabulate = [&](const std::string& methods, const std::string& ratios,
                            const std::string& seeds) {
    return tiny.run("tabulate", {"--run", "run", "--dataset", "tiny", "--published",
                                 std::string(PIAE_SOURCE) + "/results/published", "--methods",
                                 methods, "--ratios", ratios, "--seeds", seeds});
  };
  expect_refusal(tabulate("none", "7to1", "0"), "tabulate", 2, {"7to1", "100to1", "1to1"});
  expect_refusal(tabulate("none,none", "100to1", "0"), "tabulate", 2, {"none"});
  expect_refusal(tabulate("none", "10to1", "0"), "tabulate", 2, {"none", "100to1"});
  expect_refusal(tabulate("none", "100to1", "one"), "tabulate", 2, {"one"});
}

TEST(Usage, DiagnoseNeedsGeneratedWindowsOnlyIfTheRatioUsesThem) {
  const Tiny tiny;
  tiny.run_chain_before("train");
  fs::copy_file(tiny / "C.h5", tiny / "E.h5");
  const Arguments without = chain()[5].arguments;
  expect_refusal(tiny.run("diagnose", with(without, "--ratio", "50to1")), "diagnose", 2,
                 {"--generated", "100to1"});
}

}  // namespace
}  // namespace piae::stages
