#include <gtest/gtest.h>
#include <sys/stat.h>

#include "stages/tiny.hpp"

/// Behaviour of stages if their output cannot be written.
namespace piae::stages {
namespace {

/// A stage, its output option, and the file that it writes first.
struct Output {
  const char* stage;
  const char* option;
  const char* file;
};

/// Prints the name for GoogleTest.
void PrintTo(const Output& output, std::ostream* out) { *out << output.stage; }

class Outputs : public testing::TestWithParam<Output> {
 protected:
  void SetUp() override { tiny_.run_chain_before(stage_); }

  /// Sends the output to a folder; expects that the stage fails and changes no file.
  void expect_failed(const std::string& folder, const std::string& word,
                     const Surroundings& surroundings = {}) const {
    SCOPED_TRACE(folder);
    const std::set<std::string> before = tiny_.files();
    const std::string option = GetParam().option;
    const bool names_folder = option == "--output-dir";
    const Arguments arguments = with(step_of(stage_).arguments, option,
                                     names_folder ? folder : folder + '/' + GetParam().file);
    const Outcome outcome = run(tiny_.path(), stage_, arguments, surroundings);
    expect_refusal(outcome, stage_, 1, {folder, word});
    EXPECT_EQ(tiny_.files(), before);
  }

  Tiny tiny_;
  std::string stage_ = GetParam().stage;
};

TEST_P(Outputs, ImpossiblePathsAreNamedAndNothingIsLeft) {
  tiny_.write("file", "in the way");
  expect_failed("file/folder", "choose another");

  fs::create_directory(tiny_ / "fixed");
  fs::permissions(tiny_ / "fixed", fs::perms::owner_read | fs::perms::owner_exec);
  Surroundings user;
  user.without_root_rights = true;
  expect_failed("fixed", "Permission denied", user);
}

TEST_P(Outputs, FullDiskKeepsTheOldOutputs) {
  Surroundings small_disk;
  small_disk.largest_file = 2000;
  expect_failed("new", "File too large", small_disk);

  const std::string former = std::string("old/") + GetParam().file;
  tiny_.write(former, "the former one");
  expect_failed("old", "File too large", small_disk);
  EXPECT_EQ(bytes_of(tiny_ / former), "the former one");
}

TEST_P(Outputs, AreNotWrittenThroughPlantedLinks) {
  tiny_.write("victim", "precious");
  const std::string file = std::string("shared/") + GetParam().file;
  fs::create_directory(tiny_ / "shared");
  fs::create_symlink(tiny_ / "victim", tiny_ / (file + ".partial-0123456789abcdef"));
  fs::create_symlink(tiny_ / "victim", tiny_ / file);
  expect_failed("shared", "is a link");
  EXPECT_TRUE(fs::is_symlink(tiny_ / file));

  fs::remove(tiny_ / file);
  const Outcome outcome = tiny_.run(stage_, with(step_of(stage_).arguments, GetParam().option,
                                                 stage_ == "split" ? "shared" : file));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_FALSE(fs::is_symlink(tiny_ / file));
  EXPECT_EQ(bytes_of(tiny_ / "victim"), "precious");
}

INSTANTIATE_TEST_SUITE_P(Stages, Outputs,
                         testing::Values(Output{"simulate", "--output", "records.h5"},
                                         Output{"split", "--output-dir", "A.h5"},
                                         Output{"train", "--output", "model.h5"},
                                         Output{"generate", "--output", "E.h5"},
                                         Output{"score", "--output", "score.h5"},
                                         Output{"diagnose", "--output", "diagnosis.h5"}),
                         [](const auto& info) { return info.param.stage; });

// Roles of one split must not mix with those of another.
TEST(OutputsOfSplit, FailureLeavesNone) {
  const Tiny tiny;
  tiny.run_chain_before("split");
  fs::create_symlink("x", tiny / "D.h5");
  const std::set<std::string> before = tiny.files();
  expect_refusal(tiny.run_step("split"), "split", 1, {"D.h5", "is a link"});
  EXPECT_EQ(tiny.files(), before);
}

TEST(OutputsOfTabulate, FailureLeavesNoTable) {
  const Tiny tiny;
  tiny.run_chain_before("tabulate");
  tiny.write("elsewhere", "precious");
  const std::set<std::string> before = tiny.files();
  Surroundings small_disk;
  small_disk.largest_file = 200;  // some tables are smaller
  expect_refusal(run(tiny.path(), "tabulate", step_of("tabulate").arguments, small_disk),
                 "tabulate", 1, {"File too large", "free some space"});
  EXPECT_EQ(tiny.files(), before);
  for (const std::string table : {"accuracy.csv", "quality.csv", "tables.tex"}) {
    fs::create_symlink(tiny / "elsewhere", tiny / ("run/tiny/" + table));
    expect_refusal(tiny.run_step("tabulate"), "tabulate", 1, {table, "is a link"});
    fs::remove(tiny / ("run/tiny/" + table));
    EXPECT_EQ(tiny.files(), before);
  }
  EXPECT_EQ(bytes_of(tiny / "elsewhere"), "precious");
}

TEST(OutputsOfGenerate, DoNotReplaceTheirInput) {
  const Tiny tiny;
  tiny.run_chain_before("generate");
  const std::string before = bytes_of(tiny / "model.h5");
  const Arguments arguments = with(step_of("generate").arguments, "--output", "./model.h5");
  expect_refusal(tiny.run("generate", arguments), "generate", 2, {"model.h5", "is an input"});
  EXPECT_TRUE(bytes_of(tiny / "model.h5") == before);
}

TEST(OutputsOfGenerate, DoNotReplaceAnythingButFiles) {
  const Tiny tiny;
  tiny.run_chain_before("generate");
  fs::create_directory(tiny / "pipes");
  ASSERT_EQ(mkfifo((tiny / "pipes/pipe").c_str(), 0600), 0);
  const Arguments arguments = with(step_of("generate").arguments, "--output", "pipes/pipe");
  expect_refusal(tiny.run("generate", arguments), "generate", 1, {"pipes/pipe", "not a file"});
  EXPECT_TRUE(fs::is_fifo(tiny / "pipes/pipe"));
}

// A training may take hours, so unwritable outputs are reported before it starts.
TEST(OutputsOfTrain, AreCheckedBeforeTraining) {
  const Tiny tiny;
  tiny.run_chain_before("train");
  tiny.write("victim", "precious");
  Arguments arguments = with(step_of("train").arguments, "--epochs", "1000000");
  for (const std::string planted : {"model.h5", "model.h5.checkpoint"}) {
    fs::create_symlink(tiny / "victim", tiny / planted);
    expect_refusal(tiny.run("train", arguments), "train", 1, {planted + ": is a link"});
    EXPECT_TRUE(fs::is_symlink(tiny / planted));
    fs::remove(tiny / planted);
  }
  for (const std::string nameless : {"", "new/"}) {
    arguments = with(arguments, "--output", nameless);
    expect_refusal(tiny.run("train", arguments), "train", 2,
                   {"'" + nameless + "' is not the name of a file"});
  }
  EXPECT_FALSE(fs::exists(tiny / "new"));
}

}  // namespace
}  // namespace piae::stages
