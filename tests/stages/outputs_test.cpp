#include <gtest/gtest.h>

#include "stages/tiny.hpp"

/// What stages do when their output cannot be written.
namespace piae::stages {
namespace {

/// A stage, its output option, and the file that it then writes first.
struct Output {
  const char* stage;
  const char* option;
  const char* file;
};

class Outputs : public testing::TestWithParam<Output> {
 protected:
  void SetUp() override {
    tiny_.run_chain_before(GetParam().stage);
    arguments_ = step_of(GetParam().stage).arguments;
  }

  /// Sends the output to a folder.
  [[nodiscard]] Arguments into(const std::string& folder) const {
    const std::string option = GetParam().option;
    const bool names_folder = option == "--output-dir";
    return with(arguments_, option, names_folder ? folder : folder + '/' + GetParam().file);
  }
  void expect_failed(const Arguments& arguments, const std::string& word,
                     const Surroundings& surroundings = {}) const {
    const std::set<std::string> before = tiny_.files();
    const Outcome outcome = run(tiny_.path(), GetParam().stage, arguments, surroundings);
    expect_refusal(outcome, GetParam().stage, 1, {word});
    EXPECT_EQ(tiny_.files(), before);
  }

  Tiny tiny_;
  Arguments arguments_;
};

TEST_P(Outputs, FolderCannotBeMade) {
  tiny_.write("file", "in the way");
  expect_failed(into("file/folder"), "file/folder");
}

TEST_P(Outputs, FolderIsReadOnly) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write into read-only folders";
  fs::create_directory(tiny_ / "fixed");
  fs::permissions(tiny_ / "fixed", fs::perms::owner_read | fs::perms::owner_exec);
  expect_failed(into("fixed"), "Permission denied");
  fs::permissions(tiny_ / "fixed", fs::perms::owner_all);
}

TEST_P(Outputs, DiskIsFull) {
  // The temporary file leads to a device that is always full.
  const std::string partial = std::string("full/") + GetParam().file + ".partial";
  fs::create_directory(tiny_ / "full");
  fs::create_symlink("/dev/full", tiny_ / partial);
  const Outcome outcome = tiny_.run(GetParam().stage, into("full"));
  expect_refusal(outcome, GetParam().stage, 1, {GetParam().file, "No space left", "room"});
  EXPECT_TRUE(fs::is_empty(tiny_ / "full"));
}

TEST_P(Outputs, DiskIsFullInTheMiddleOfAFile) {
  Surroundings surroundings;
  surroundings.largest_file = 2000;
  expect_failed(into("part"), "File too large", surroundings);
}

TEST_P(Outputs, FailureLeavesTheFormerFile) {
  tiny_.write(std::string("old/") + GetParam().file, "the former one");
  Surroundings surroundings;
  surroundings.largest_file = 2000;
  expect_failed(into("old"), "File too large", surroundings);
  EXPECT_EQ(bytes_of(tiny_ / (std::string("old/") + GetParam().file)), "the former one");
}

INSTANTIATE_TEST_SUITE_P(Stages, Outputs,
                         testing::Values(Output{"simulate", "--output", "records.h5"},
                                         Output{"split", "--output-dir", "A.h5"},
                                         Output{"train", "--output", "model.h5"},
                                         Output{"generate", "--output", "E.h5"},
                                         Output{"score", "--output", "score.h5"},
                                         Output{"diagnose", "--output", "diagnosis.h5"}),
                         [](const auto& info) { return info.param.stage; });

TEST(OutputsOfTabulate, FullDiskLeavesNoTable) {
  const Tiny tiny;
  tiny.run_chain_before("tabulate");
  const std::set<std::string> before = tiny.files();
  fs::create_symlink("/dev/full", tiny / "run/tiny/accuracy.csv.partial");
  expect_refusal(tiny.run_step("tabulate"), "tabulate", 1, {"accuracy.csv", "No space left"});
  EXPECT_EQ(tiny.files(), before);
}

}  // namespace
}  // namespace piae::stages
