#include "base/regular_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>

#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae {
namespace {

TEST(RegularFile, IsReadInPieces) {
  const Folder folder;
  const RegularFile file(folder.write("abc.txt", "abc"));
  std::array<std::byte, 2> piece{};
  EXPECT_EQ(file.size(), 3U);
  EXPECT_EQ(file.read(piece), 2U);
  EXPECT_EQ(file.read(piece), 1U);
  EXPECT_EQ(piece.front(), std::byte{'c'});
  EXPECT_EQ(file.read(piece), 0U);
}

TEST(RegularFile, RefusesPipesFoldersAndDevices) {
  const Folder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_ERROR(RegularFile(folder / "pipe"), Exit::input_missing, "pipe: is not a file");
  EXPECT_ERROR(RegularFile(folder.path()), Exit::input_missing, "is not a file");
  EXPECT_ERROR(RegularFile("/dev/zero"), Exit::input_missing, "/dev/zero: is not a file");
  EXPECT_ERROR(RegularFile(folder / "none"), Exit::input_missing, "none: No such file");
}

}  // namespace
}  // namespace piae
