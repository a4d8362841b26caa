#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "stages/program.hpp"
#include "support/folder.hpp"

/// Reads a recording while the process for that ends badly. A script takes the place of this
/// process.
namespace piae::stages {
namespace {

using testing::StartsWith;

/// Returns what read_raw says if the process that it starts does this.
std::string said(const std::string& commands) {
  const Folder folder;
  folder.write("a.csv", "1\n2\n");
  // read_raw starts the program of that name next to itself.
  fs::copy_file(fs::path(PIAE_BIN) / "read_raw", folder / "reads");
  fs::permissions(folder.write("read_raw", "#!/bin/sh\n" + commands + '\n'), fs::perms::owner_all);
  const int status = std::system(
      ("cd " + folder.path().string() + " && ./reads --file a.csv --variable 1 2>err").c_str());
  EXPECT_EQ(WEXITSTATUS(status), 65);
  return bytes_of(folder / "err");
}

const std::string beginning = "read_raw: a.csv: cannot be read: its reader ";

TEST(AReader, ThatIsStoppedIsReported) {
  EXPECT_THAT(
      said("kill -XCPU $$"),
      StartsWith(beginning + "was stopped after 5 s of processor time, too much for its size"));
  EXPECT_THAT(said("kill -SEGV $$"), StartsWith(beginning + "crashed (signal 11)"));
  EXPECT_THAT(said("echo 'read_raw: out of memory' >&2; exit 1"),
              StartsWith(beginning + "failed with 66 MB of memory (out of memory)"));
  EXPECT_THAT(said("exit 7"), StartsWith(beginning + "ended with exit code 7"));
  EXPECT_THAT(said("exit 0"), StartsWith(beginning + "returned too few samples"));
}

TEST(AReader, ThatDoesNotEndIsStopped) {
  EXPECT_THAT(said("exec sleep 600"),
              StartsWith(beginning + "took longer than 15 s, too long for its size"));
}

}  // namespace
}  // namespace piae::stages
