#include "storm/bench.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "storm/files.hpp"
#include "support/folder.hpp"

namespace piae::storm {
namespace {

namespace fs = std::filesystem;
using testing::MatchesRegex;
using testing::StartsWith;

void write_program(const fs::path& path, const std::string& commands) {
  write_bytes(path, "#!/bin/sh\n" + commands + "\n");
  fs::permissions(path, fs::perms::owner_all);
}

/// Two stages read x.h5: `train` copies it, `score` counts its bytes. `verify` accepts everything.
class TwoReaders : public testing::Test {
 protected:
  TwoReaders() {
    for (const char* part : {"corpus", "programs"}) fs::create_directories(folder_ / part);
    write_bytes(folder_ / "corpus/x.h5", "content");
    write_bytes(folder_ / "corpus/consumers", "x.h5 train x.h5\nx.h5 score x.h5\n");
  }

  /// A workbench whose programs behave well with the good artefact.
  [[nodiscard]] Workbench bench() const {
    write_program(programs() / "verify", "exit 0");
    write_program(programs() / "train", "cp \"$1\" out.h5");
    write_program(programs() / "score", "wc -c <\"$1\" >out.h5");
    return {folder_ / "corpus", folder_ / "work", programs()};
  }
  [[nodiscard]] fs::path programs() const { return folder_ / "programs"; }

 private:
  Folder folder_;
};

TEST_F(TwoReaders, AreComparedWithTheirOwnOutput) {
  Workbench workbench = bench();
  for (const Consumer& consumer : workbench.consumers()) {
    const Verdict verdict = workbench.judge(consumer, "content", true);
    EXPECT_EQ(verdict.finding, "") << consumer.stage;
    EXPECT_FALSE(verdict.refused) << consumer.stage;
  }
}

TEST_F(TwoReaders, AreReportedIfOneDiffers) {
  Workbench workbench = bench();
  const std::vector<Consumer>& consumers = workbench.consumers();
  EXPECT_EQ(workbench.judge(consumers.at(0), "CONTENT", true).finding,
            "train made something else of it, silently");
  EXPECT_EQ(workbench.judge(consumers.at(1), "CONTENT", true).finding, "");
  EXPECT_EQ(workbench.judge(consumers.at(1), "more content", true).finding,
            "score made something else of it, silently");
}

/// Returns the finding if `train`, or another program, does this with an altered artefact.
class BrokenPromise : public TwoReaders {
 protected:
  std::string finding(const std::string& commands, const std::string& program = "train") {
    Workbench workbench = bench();
    write_program(programs() / program, commands);
    return workbench.judge(workbench.consumers().at(0), "CONTENT", false).finding;
  }
};

TEST_F(BrokenPromise, IsNoneIfTheStageNamesTheFile) {
  EXPECT_EQ(finding("echo 'train: x.h5: is damaged' >&2; exit 65"), "");
  EXPECT_EQ(finding("echo 'train: the training diverges' >&2; exit 1"), "");
}

TEST_F(BrokenPromise, IsACrashOrTooMuchMemory) {
  EXPECT_THAT(finding("kill -SEGV $$"), StartsWith("train was ended by signal 11"));
  EXPECT_THAT(finding("kill -SEGV $$", "verify"), StartsWith("verify was ended by signal 11"));
  EXPECT_THAT(finding("head -c 1100000000 /dev/zero | tail -c 1100000000 >/dev/null"),
              MatchesRegex("train took 1[0-9]{3}[.][0-9]+ MB.*"));
}

TEST_F(BrokenPromise, IsARefusalThatIsNotAsDocumented) {
  EXPECT_THAT(finding("echo 'train: x.h5: is odd' >&2; exit 3"), StartsWith("train ended with 3"));
  EXPECT_THAT(finding("echo 'train: is odd' >&2; exit 65"),
              StartsWith("train does not name the file"));
  EXPECT_THAT(finding("echo 'x.h5: is odd' >&2; exit 65"),
              StartsWith("an error without its stage"));
  EXPECT_THAT(finding("echo 1 >x.part; echo 'train: x.h5: is odd' >&2; exit 65"),
              StartsWith("train refused and left x.part"));
  EXPECT_THAT(finding("exit 0"), StartsWith("train left other files than of the good artefact"));
}

TEST_F(BrokenPromise, IsAVerifyThatSaysTooLittleOrTooMuch) {
  EXPECT_EQ(finding("exit 4", "verify"), "verify refused without a word");
  EXPECT_THAT(finding("echo y.h5: is odd; exit 4", "verify"),
              StartsWith("verify does not name the file"));
  EXPECT_THAT(finding("echo x.h5: is odd; exit 2", "verify"), StartsWith("verify ended with 2"));
  EXPECT_THAT(finding("echo x.h5: is odd", "verify"), StartsWith("verify found all good, but"));
  EXPECT_THAT(finding("echo x.h5: is odd >&2; exit 4", "verify"),
              StartsWith("verify printed errors"));
}

TEST_F(BrokenPromise, IsAFileThatOnlyOneOfBothRefuses) {
  Workbench workbench = bench();
  write_program(programs() / "verify", "echo x.h5: is odd; exit 4");
  EXPECT_THAT(workbench.judge(workbench.consumers().at(1), "CONTENT", true).finding,
              StartsWith("score used what verify refuses"));
  write_program(programs() / "verify", "exit 0");
  write_program(programs() / "score", "echo 'score: x.h5: is odd' >&2; exit 65");
  EXPECT_THAT(workbench.judge(workbench.consumers().at(1), "CONTENT", true).finding,
              StartsWith("verify found nothing, but score: x.h5: is odd"));
}

}  // namespace
}  // namespace piae::storm
