#include "storm/bench.hpp"

#include <gtest/gtest.h>

#include "storm/files.hpp"
#include "support/folder.hpp"

namespace piae::storm {
namespace {

namespace fs = std::filesystem;

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
    write_program(folder_ / "programs/verify", "exit 0");
    write_program(folder_ / "programs/train", "cp \"$1\" out.h5");
    write_program(folder_ / "programs/score", "wc -c <\"$1\" >out.h5");
  }

  [[nodiscard]] Workbench bench() const {
    return {folder_ / "corpus", folder_ / "work", folder_ / "programs"};
  }

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

}  // namespace
}  // namespace piae::storm
