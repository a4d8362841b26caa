#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "stages/tiny.hpp"

namespace piae::stages {
namespace {

/// Every program of the project is tested.
class Usage : public testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] Outcome help() const { return run(folder_.path(), GetParam(), {"--help"}); }
  /// Returns the arguments of the example in the help, without the pipe that may follow.
  [[nodiscard]] Arguments example() const {
    const std::string text = help().out;
    const std::string beginning = "Example:\n  " + GetParam() + ' ';
    const std::size_t begin = text.find(beginning);
    EXPECT_NE(begin, std::string::npos) << text;
    std::istringstream words(
        text.substr(begin + beginning.size(),
                    text.find('\n', begin + beginning.size()) - begin - beginning.size()));
    Arguments arguments;
    for (std::string word; words >> word && word != "|";) arguments.push_back(word);
    return arguments;
  }

  const Folder folder_;
};

TEST_P(Usage, HelpShowsAnExample) {
  EXPECT_EQ(help().status, 0);
  EXPECT_EQ(help().err, "");
  EXPECT_THAT(example(), testing::Not(testing::IsEmpty()));
}

TEST_P(Usage, VersionIsOneLineWithTheNumber) {
  const Outcome version = run(folder_.path(), GetParam(), {"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.err, "");
  EXPECT_THAT(version.out,
              testing::MatchesRegex("piae-dt " + GetParam() +
                                    " [0-9]+[.][0-9]+[.][0-9]+( [(][0-9a-f]+(-changed)?[)])?\n"));
}

TEST_P(Usage, FailsWhenTheOutputCannotBeWritten) {
  const std::string help = std::string(PIAE_BIN) + '/' + GetParam() + " --help >/dev/full 2>";
  const int status = std::system((help + (folder_ / "err").string()).c_str());
  EXPECT_EQ(WEXITSTATUS(status), 1);
  EXPECT_EQ(bytes_of(folder_ / "err"),
            GetParam() + ": standard output: cannot be written completely; is the disk full?\n");
}

TEST_P(Usage, WithoutArgumentsIsAUsageErrorIfAnyIsRequired) {
  const bool has_defaults = GetParam() == "plan" || GetParam() == "status";
  if (has_defaults) return;
  expect_refusal(run(folder_.path(), GetParam(), {}), GetParam(), 2, {"required", "--help"});
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_P(Usage, UnknownOptionIsNamed) {
  fs::create_directory(folder_ / "pipeline");
  fs::copy_file(std::string(PIAE_SOURCE) + "/pipeline/protocol.toml",
                folder_ / "pipeline/protocol.toml");
  Arguments arguments = example();
  arguments.emplace_back("--colour");
  expect_refusal(run(folder_.path(), GetParam(), arguments), GetParam(), 2, {"--colour"});
  fs::remove_all(folder_ / "pipeline");
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

std::vector<std::string> programs() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(fs::path(PIAE_SOURCE) / "stages")) {
    if (entry.path().extension() == ".cpp") names.push_back(entry.path().stem());
  }
  std::ranges::sort(names);
  return names;
}
INSTANTIATE_TEST_SUITE_P(Programs, Usage, testing::ValuesIn(programs()),
                         [](const auto& info) { return info.param; });

TEST(UsageOfSome, TrainHelpShowsTheOptionsOfTheMethod) {
  const Folder folder;
  const Outcome help = run(folder.path(), "train", {"--method", "piae-dt", "--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_NE(help.out.find("--learning-rate"), std::string::npos) << help.out;
}

/// piae-dt-phase always draws class by class.
TEST(UsageOfSome, TrainHelpShowsNoUnusedOption) {
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

TEST(UsageOfSome, ImpossibleValuesAreNamedWithKnownOnes) {
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

TEST(UsageOfSome, UnknownMethodIsNamedWithKnownOnes) {
  const Tiny tiny;
  tiny.run_chain_before("train");
  expect_refusal(tiny.run("train", {"--method", "magic", "--known", "C.h5", "--seed", "0",
                                    "--output", "model.h5"}),
                 "train", 2, {"magic", "piae-dt"});
}

TEST(UsageOfSome, UnknownPartsOfTheGridAreNamed) {
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

TEST(UsageOfSome, DiagnoseNeedsGeneratedWindowsOnlyIfTheRatioUsesThem) {
  const Tiny tiny;
  tiny.run_chain_before("train");
  fs::copy_file(tiny / "C.h5", tiny / "E.h5");
  const Arguments without = chain()[5].arguments;
  expect_refusal(tiny.run("diagnose", with(without, "--ratio", "50to1")), "diagnose", 2,
                 {"--generated", "100to1"});
}

}  // namespace
}  // namespace piae::stages
