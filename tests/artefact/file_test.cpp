#include "artefact/file.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <set>

#include "support/child_process.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::artefact {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

void write_text(const fs::path& file, const std::string& text) {
  write_file_atomically(file, std::as_bytes(std::span(text)));
}

std::set<std::string> names_in(const Folder& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

TEST(WrittenFile, IsNotWrittenThroughAPlantedLink) {
  const Folder folder;
  const fs::path victim = folder.write("victim", "precious");
  fs::create_symlink(victim, folder / "a.h5.partial-0123456789abcdef");
  write_text(folder / "a.h5", "new");
  EXPECT_EQ(bytes_of(victim), "precious");
  EXPECT_EQ(bytes_of(folder / "a.h5"), "new");
}

TEST(WrittenFile, DoesNotReplaceALink) {
  const Folder folder;
  const fs::path victim = folder.write("victim", "precious");
  fs::create_symlink(victim, folder / "a.h5");
  fs::create_symlink(folder / "nowhere", folder / "b.h5");
  for (const std::string name : {"a.h5", "b.h5"}) {
    EXPECT_ERROR(write_text(folder / name, "new"), Exit::failed, name + ": is a link");
    EXPECT_TRUE(fs::is_symlink(folder / name));
  }
  EXPECT_EQ(bytes_of(victim), "precious");
  EXPECT_THAT(names_in(folder), ElementsAre("a.h5", "b.h5", "victim"));
}

TEST(WrittenFile, RemovesRemainsOfKilledWriters) {
  const Folder folder;
  folder.write("a.h5.partial-0123456789abcdef", "half");
  folder.write("a.h5.partial-fedcba9876543210", "");
  write_text(folder / "a.h5", "new");
  EXPECT_THAT(names_in(folder), ElementsAre("a.h5"));

  folder.write("a.h5.partial-0123456789abcdef", "half");
  remove_file(folder / "a.h5");
  EXPECT_THAT(names_in(folder), testing::IsEmpty());
}

TEST(WrittenFile, KeepsFilesOfOtherWriters) {
  const Folder folder;
  const std::set<std::string> others{"a.h5.partial-0123456789abcdef",
                                     "b.h5.partial-0123456789abcdef", "a.h5.partial-of-mine",
                                     "a.h5.partial"};
  for (const std::string& name : others) folder.write(name, "half");
  const std::string being_written = "a.h5.partial-0123456789abcdef";
  const int written = ::open((folder / being_written).c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_EQ(::flock(written, LOCK_EX), 0);
  write_text(folder / "a.h5", "new");
  remove_file(folder / "a.h5");
  EXPECT_EQ(names_in(folder), others);
  ::close(written);
}

TEST(WrittenFile, IsCompleteWithConcurrentWriters) {
  const Folder folder;
  constexpr int writers = 6;
  std::vector<pid_t> children;
  for (int writer = 0; writer < writers; ++writer) {
    children.push_back(::fork());
    if (children.back() > 0) continue;
    const std::string text(10000, static_cast<char>('a' + writer));
    for (int i = 0; i < 30; ++i) {
      if (error_of([&] { write_text(folder / "a.h5", text); })) ::_exit(1);
    }
    ::_exit(0);
  }
  for (const pid_t child : children) {
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  const std::string last = bytes_of(folder / "a.h5");
  EXPECT_EQ(last, std::string(10000, last.at(0)));
  EXPECT_THAT(names_in(folder), ElementsAre("a.h5"));
}

TEST(WrittenFile, LeavesNothingIfTooLarge) {
  const Folder folder;
  folder.write("a.h5", "old");
  const int status = status_of_child([&] {
    const rlimit limit{100, 100};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    write_text(folder / "a.h5", std::string(1000, 'x'));
  });
  EXPECT_EQ(status, static_cast<int>(Exit::failed));
  EXPECT_EQ(bytes_of(folder / "a.h5"), "old");
  EXPECT_THAT(names_in(folder), ElementsAre("a.h5"));
}

TEST(ReadFile, DoesNotWaitForAPipe) {
  const Folder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  const int status = status_of_child([&] {
    ::alarm(5);
    (void)read_file(folder / "pipe");
  });
  EXPECT_EQ(status, static_cast<int>(Exit::input_missing));
}

// A sparse file claims gigabytes that are not on the disk.
TEST(ReadFile, RefusesALargeFileWithoutReadingIt) {
  const Folder folder;
  write_text(folder / "a", "1234");
  fs::resize_file(folder / "a", 12'000'000'000);
  EXPECT_ERROR(read_file(folder / "a", 4'000'000'000), Exit::bad_input,
               "a: is larger than 4000 MB");
  fs::resize_file(folder / "a", 4);
  EXPECT_EQ(read_file(folder / "a", 4).size(), 4U);
}

}  // namespace
}  // namespace piae::artefact
