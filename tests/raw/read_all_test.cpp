#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "raw/file.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

/// Several files by one run of read_raw.
namespace piae::raw {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(ReadAll, GivesSamplesAndColumnsOfEachFileInTheirOrder) {
  const Folder folder;
  const std::vector<Signal> signals =
      read_all({folder.write("b.csv", "0.5,1\n1.5,2\n"), folder.write("a.csv", "7\n8\n9\n"),
                folder.write("empty.csv", ""), folder.write("odd\nname .csv", "3\n4\n")},
               "1");
  ASSERT_EQ(signals.size(), 4U);
  EXPECT_THAT(signals[0].samples, ElementsAre(0.5, 1.5));
  EXPECT_EQ(signals[0].columns, 2U);
  EXPECT_THAT(signals[1].samples, ElementsAre(7, 8, 9));
  EXPECT_EQ(signals[1].columns, 1U);
  EXPECT_THAT(signals[2].samples, IsEmpty());
  EXPECT_THAT(signals[3].samples, ElementsAre(3, 4));
}

TEST(ReadAll, ReadsMoreThanAPipeHolds) {
  const Folder folder;
  std::string text;
  for (int i = 0; i < 20000; ++i) text += std::to_string(i) + '\n';
  const auto file = folder.write("a.csv", text);
  const std::vector<Signal> signals = read_all(std::vector(50, file), "1");
  ASSERT_EQ(signals.size(), 50U);
  for (const Signal& signal : signals) {
    ASSERT_EQ(signal.samples.size(), 20000U);
    EXPECT_EQ(signal.samples[19999], 19999);
  }
}

TEST(ReadAll, NamesTheFileThatCannotBeRead) {
  const Folder folder;
  const auto good = folder.write("good.csv", "1\n2\n");
  EXPECT_ERROR(read_all({good, folder.write("bad.csv", "1\nx\n"), good}, "1"), Exit::bad_input,
               (folder / "bad.csv").string() + ", line 2: ");
  EXPECT_ERROR(read_all({good, folder / "none.csv"}, "1"), Exit::input_missing,
               (folder / "none.csv").string() + ": ");
  const auto large = folder.write("large.csv", "1\n");
  std::filesystem::resize_file(large, 2'500'000'000);
  EXPECT_ERROR(read_all({good, large, large}, "1"), Exit::bad_input,
               large.string() + ": and the files before it are larger than 4000 MB");
}

}  // namespace
}  // namespace piae::raw
