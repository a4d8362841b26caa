#include "text/lines.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::text {
namespace {

TEST(Lines, AreReadInOrder) {
  const Folder folder;
  EXPECT_THAT(read_lines(folder.write("a.txt", "one\n\ntwo\r\nthree")),
              testing::ElementsAre("one", "", "two\r", "three"));
  EXPECT_THAT(read_lines(folder.write("b.txt", "")), testing::IsEmpty());
}

TEST(Lines, RefuseAPipe) {
  const Folder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_ERROR(read_lines(folder / "pipe"), Exit::input_missing, "pipe: is not a file");
}

}  // namespace
}  // namespace piae::text
