#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "raw/file.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

/// Several files in one run of read_raw.
namespace piae::raw {
namespace {

using testing::ElementsAre;

TEST(ReadAll, GivesSamplesAndColumnsOfEachFileInOrder) {
  const Folder folder;
  const Signals signals =
      read_all({folder.write("b.csv", "0.5,1\n1.5,2\n"), folder.write("a.csv", "7\n8\n9\n"),
                folder.write("odd\nname .csv", "3\n4\n")},
               "1");
  EXPECT_THAT(signals.samples, ElementsAre(0.5, 1.5, 7, 8, 9, 3, 4));
  ASSERT_EQ(signals.pieces.size(), 3U);
  EXPECT_EQ(signals.pieces[0].samples, 2U);
  EXPECT_EQ(signals.pieces[0].columns, 2U);
  EXPECT_EQ(signals.pieces[1].samples, 3U);
  EXPECT_EQ(signals.pieces[1].columns, 1U);
  EXPECT_EQ(signals.pieces[2].samples, 2U);
}

TEST(ReadAll, ReadsMoreThanAPipeHolds) {
  const Folder folder;
  std::string text;
  for (int i = 0; i < 20000; ++i) text += std::to_string(i) + '\n';
  const auto file = folder.write("a.csv", text);
  const Signals signals = read_all(std::vector(50, file), "1");
  ASSERT_EQ(signals.pieces.size(), 50U);
  ASSERT_EQ(signals.samples.size(), 50U * 20000);
  for (std::size_t i = 0; i < 50; ++i) EXPECT_EQ(signals.samples[i * 20000 + 19999], 19999);
}

TEST(ReadAll, ReadsFilesOfDifferentLengths) {
  const Folder folder;
  std::vector<std::filesystem::path> files;
  for (int i = 1; i <= 40; ++i) {
    std::string text;
    for (int j = 0; j < 40 * (i % 7) + i; ++j) text += std::to_string(100 * i + j) + '\n';
    files.push_back(folder.write(std::to_string(i) + ".csv", text + "0.5\n0.25\n"));
  }
  const Signals signals = read_all(files, "1");
  std::size_t at = 0;
  for (std::size_t i = 1; i <= 40; ++i) {
    const std::size_t count = 40 * (i % 7) + i + 2;
    ASSERT_EQ(signals.pieces[i - 1].samples, count);
    EXPECT_EQ(signals.samples[at], 100. * static_cast<double>(i));
    at += count;
    EXPECT_EQ(signals.samples[at - 1], 0.25);
  }
  EXPECT_EQ(signals.samples.size(), at);
}

/// Whole numbers have any length, so a cut one is not damaged for certain.
TEST(ReadAll, MarksAFileThatMayBeCutWithinItsLastNumber) {
  const Folder folder;
  std::string text;
  for (int i = 0; i < 200; ++i) text += std::to_string(12345 - 100 * i) + '\n';
  const auto whole = folder.write("whole.txt", text);
  const auto cut = folder.write("cut.txt", text + "45");
  const auto complete = folder.write("complete.txt", text + "45\n");
  const auto usual = folder.write("usual.txt", text + "-4500");
  const Signals found = read_all({whole, cut, complete, usual}, "1");
  ASSERT_EQ(found.pieces.size(), 4U);
  EXPECT_EQ(found.pieces[0].may_be_cut, 0U);
  EXPECT_EQ(found.pieces[1].may_be_cut, 1U);
  EXPECT_EQ(found.pieces[2].may_be_cut, 0U);
  EXPECT_EQ(found.pieces[3].may_be_cut, 0U);
}

TEST(ReadAll, NamesTheFileThatCannotBeRead) {
  const Folder folder;
  const auto good = folder.write("good.csv", "1\n2\n");
  EXPECT_ERROR(read_all({good, folder.write("bad.csv", "1\nx\n"), good}, "1"), Exit::bad_input,
               (folder / "bad.csv").string() + ", line 2: ");
  EXPECT_ERROR(read_all({good, folder.write("empty.csv", ""), good}, "1"), Exit::bad_input,
               (folder / "empty.csv").string() + ": 1 holds no sample");
  EXPECT_ERROR(read_all({good, folder / "none.csv"}, "1"), Exit::input_missing,
               (folder / "none.csv").string() + ": ");
  const auto large = folder.write("large.csv", "1\n");
  std::filesystem::resize_file(large, 2'500'000'000);
  EXPECT_ERROR(read_all({good, large, large}, "1"), Exit::bad_input,
               large.string() + ": and the files before it are larger than 4000 MB");
}

}  // namespace
}  // namespace piae::raw
