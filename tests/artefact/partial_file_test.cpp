#include "artefact/partial_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <set>
#include <string>
#include <vector>

#include "artefact/file.hpp"
#include "support/folder.hpp"

namespace piae::artefact {
namespace {

/// One call of fsync: its file, the file's name, and whether the final name existed at that time.
struct Synced {
  ino_t inode;
  std::string name;
  bool has_its_name;
};
std::vector<Synced> synced;
std::filesystem::path name_of_file;

}  // namespace

/// Replaces the C library's fsync and records the call.
extern "C" int fsync(int descriptor) {
  struct stat status {};
  if (::fstat(descriptor, &status) == 0) {
    const auto name = std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor));
    synced.push_back({status.st_ino, name.filename(), std::filesystem::exists(name_of_file)});
  }
  return static_cast<int>(::syscall(SYS_fsync, descriptor));
}

namespace {

ino_t inode_of(const std::filesystem::path& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 ? status.st_ino : 0;
}

/// Otherwise a power cut could leave an empty file with the final name, or none.
TEST(PartialFile, IsSyncedBeforeItIsRenamedAndItsFolderAfterwards) {
  const Folder folder;
  name_of_file = folder.path() / "model.h5";
  synced.clear();
  write_file_atomically(name_of_file, std::as_bytes(std::span("model")));
  ASSERT_EQ(synced.size(), 2U);
  EXPECT_EQ(synced[0].inode, inode_of(name_of_file));
  EXPECT_FALSE(synced[0].has_its_name);
  EXPECT_EQ(synced[1].inode, inode_of(folder.path()));
  EXPECT_TRUE(synced[1].has_its_name);
}

/// Otherwise somebody could plant a link with that name.
TEST(PartialFile, HasANameThatNobodyCanKnow) {
  const Folder folder;
  std::set<std::string> names;
  for (int i = 0; i < 20; ++i) {
    synced.clear();
    write_file_atomically(folder / "model.h5", std::as_bytes(std::span("model")));
    EXPECT_THAT(synced.at(0).name, testing::MatchesRegex("model.h5.partial-[0-9a-f]{16}"));
    names.insert(synced.at(0).name);
  }
  EXPECT_EQ(names.size(), 20U);
}

}  // namespace
}  // namespace piae::artefact
