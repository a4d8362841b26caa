#include <gtest/gtest.h>
#include <sys/stat.h>

#include "stages/tiny.hpp"

/// Options from a TOML file.
namespace piae::stages {
namespace {

const Arguments split_files{"--config", "options.toml", "--records", "records.h5", "--seed",
                            "0",        "--output-dir", "configured"};
const Arguments train_files{"--config", "options.toml", "--known",      "C.h5", "--seed",
                            "0",        "--output",     "configured.h5"};

void expect_same_bytes(const fs::path& one, const fs::path& other) {
  EXPECT_TRUE(bytes_of(one) == bytes_of(other)) << one << ' ' << other;
}

TEST(Config, EqualsTheCommandLine) {
  const Tiny tiny;
  tiny.run_chain_before("generate");
  tiny.write("options.toml", R"(
[split]
windows-per-class = 40
test-per-class = 10   # a comment
known-per-class = 5
[train]
method = "piae-dt"
epochs = 9            # the method's own table wins
[train.piae-dt]
width = 8
epochs = 4
[train.other]
colour = "not this program's business"
[diagnose]
colour = "not this program's business"
)");
  const Outcome split = tiny.run("split", split_files);
  ASSERT_EQ(split.status, 0) << split.err;
  expect_same_bytes(tiny / "C.h5", tiny / "configured/C.h5");
  const Outcome train = tiny.run("train", train_files);
  ASSERT_EQ(train.status, 0) << train.err;
  expect_same_bytes(tiny / "model.h5", tiny / "configured.h5");
}

TEST(Config, FileForOneProgramNeedsNoTable) {
  const Tiny tiny;
  tiny.run_chain_before("train");
  tiny.write("options.toml", "windows-per-class = 40\ntest-per-class = 10\nknown-per-class = 5\n");
  ASSERT_EQ(tiny.run("split", split_files).status, 0);
  expect_same_bytes(tiny / "A.h5", tiny / "configured/A.h5");
}

TEST(Config, CommandLineWins) {
  const Tiny tiny;
  tiny.run_chain_before("train");
  tiny.write(
      "options.toml",
      "[split]\nseed = 7\nwindows-per-class = 30\ntest-per-class = 10\nknown-per-class = 5\n");
  ASSERT_EQ(tiny.run("split", with(split_files, "--windows-per-class", "40")).status, 0);
  expect_same_bytes(tiny / "A.h5", tiny / "configured/A.h5");
}

/// Expects that options.toml with this text is refused with these words, and nothing is written.
void expect_text_refused(const std::string& text, std::vector<std::string> words) {
  SCOPED_TRACE(text);
  const Tiny tiny;
  tiny.write("options.toml", text);
  const std::set<std::string> before = tiny.files();
  words.emplace_back("options.toml");
  expect_refusal(tiny.run("split", split_files), "split", 2, words);
  EXPECT_EQ(tiny.files(), before);
}

TEST(Config, UnknownKeyIsNamed) {
  expect_text_refused("[split]\ncolour = 3\n", {"colour"});
  expect_text_refused("colour = 3\n", {"colour"});
}

TEST(Config, InvalidFileIsNamedWithTheLine) {
  expect_text_refused("[split]\nwindow = \n", {"options.toml, line 2: not valid TOML: "});
  expect_text_refused("\x89PNG", {"TOML"});
}

TEST(Config, WrongValueIsNamed) {
  const Tiny tiny;
  tiny.write("options.toml", "[split]\nwindow = \"wide\"\n");
  expect_refusal(tiny.run("split", split_files), "split", 2, {"window", "wide"});
}

TEST(Config, MissingFileIsAMissingInput) {
  const Tiny tiny;
  expect_refusal(tiny.run("split", split_files), "split", 66, {"options.toml"});
  expect_refusal(tiny.run("train", with(train_files, "--method", "piae-dt")), "train", 66,
                 {"options.toml"});
}

TEST(Config, EveryStepOfTheChainReadsTheProtocolOfTheProject) {
  // Run up to the first missing input: by then all options have been read.
  const Tiny tiny;
  const std::string protocol = std::string(PIAE_SOURCE) + "/pipeline/protocol.toml";
  for (const std::string stage : {"split", "train", "generate", "score", "diagnose", "tabulate"}) {
    const Outcome outcome = tiny.run(stage, with(step_of(stage).arguments, "--config", protocol));
    EXPECT_EQ(outcome.status, 66) << stage << ": " << outcome.err;
  }
}

TEST(Config, UnreadableOrHugeFileIsRefused) {
  const Tiny tiny;
  tiny.run_chain_before("split");
  fs::create_symlink("/proc/self/mem", tiny / "options.toml");
  expect_refusal(tiny.run("split", split_files), "split", 2, {"options.toml", "cannot be read"});
  expect_refusal(tiny.run("train", train_files), "train", 2, {"options.toml", "cannot be read"});
  fs::remove(tiny / "options.toml");
  tiny.write("options.toml", "\n");
  fs::resize_file(tiny / "options.toml", 12'000'000'000);
  expect_refusal(tiny.run("train", train_files), "train", 2, {"options.toml", "larger than 1 MB"});
}

TEST(Config, PipeOrDeepNestIsRefusedAtOnce) {
  const Tiny tiny;
  tiny.run_chain_before("split");
  ASSERT_EQ(::mkfifo((tiny / "options.toml").c_str(), 0600), 0);
  expect_refusal(tiny.run("split", split_files), "split", 66, {"options.toml", "not a file"});
  expect_refusal(tiny.run("train", train_files), "train", 66, {"options.toml", "not a file"});
  fs::remove(tiny / "options.toml");
  std::string deep = "a";
  for (int i = 0; i < 200000; ++i) deep += ".a";
  tiny.write("options.toml", deep + " = 1\n");
  expect_refusal(tiny.run("split", split_files), "split", 2, {"options.toml", "dots"});
}

}  // namespace
}  // namespace piae::stages
