#include "monitor/input.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <fstream>
#include <thread>

#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::monitor {
namespace {

namespace fs = std::filesystem;

void append_to(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary | std::ios::app) << text;
}

/// Returns the bytes of an input until no more come, with "|" for a break and "." for the end.
std::string read_on(Input& input) {
  std::array<std::byte, 4> buffer{};
  std::string text;
  for (;;) {
    const Input::Piece piece = input.read(buffer);
    switch (piece.event) {
      case Input::Event::bytes:
        for (const std::byte byte : piece.bytes) text += static_cast<char>(byte);
        break;
      case Input::Event::broken:
        text += "|";
        break;
      case Input::Event::none:
        return text;
      case Input::Event::end:
        return text + ".";
    }
  }
}

TEST(Input, ReadsAFileToItsEnd) {
  const Folder folder;
  Input input(folder.write("raw", "abcdefghij"), false);
  EXPECT_EQ(read_on(input), "abcdefghij.");
}

TEST(Input, FollowsAGrowingFile) {
  const Folder folder;
  const fs::path file = folder.write("raw", "abcdef");
  Input input(file, true);
  EXPECT_EQ(read_on(input), "abcdef");
  append_to(file, "ghi");
  EXPECT_EQ(read_on(input), "ghi");
  EXPECT_EQ(read_on(input), "");
}

TEST(Input, RestartsATruncatedFile) {
  const Folder folder;
  const fs::path file = folder.write("raw", "abcdef");
  Input input(file, true);
  EXPECT_EQ(read_on(input), "abcdef");
  folder.write("raw", "gh");
  EXPECT_EQ(read_on(input), "|gh");
}

TEST(Input, ReadsAReplacedFileToItsEndFirst) {
  const Folder folder;
  const fs::path file = folder.write("raw", "abc");
  Input input(file, true);
  EXPECT_EQ(read_on(input), "abc");
  append_to(file, "de");
  fs::rename(file, folder / "raw.1");
  EXPECT_EQ(read_on(input), "de");  // the new file does not exist yet
  folder.write("raw", "fghij");
  EXPECT_EQ(read_on(input), "|fghij");
}

TEST(Input, ReadsAPipeUntilItsWriterClosesIt) {
  const Folder folder;
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { append_to(pipe, "abcdef"); });
  Input input(pipe, false);
  writer.join();
  EXPECT_EQ(read_on(input), "abcdef.");
}

TEST(Input, RefusesInputsWithoutAStream) {
  const Folder folder;
  EXPECT_ERROR(Input(folder / "none", false), Exit::input_missing, "none: No such file");
  EXPECT_ERROR(Input(folder.path(), false), Exit::input_missing, "is a folder");
  EXPECT_ERROR(Input("-", true), Exit::usage, "--follow is for files that grow");
}

}  // namespace
}  // namespace piae::monitor
