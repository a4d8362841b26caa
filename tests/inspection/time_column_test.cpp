#include "inspection/time_column.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/folder.hpp"

namespace piae::inspection {
namespace {

using Times = std::vector<double>;

/// 12 kHz, printed with so many digits after the point, without these samples.
Times times_without(std::size_t first, std::size_t count, double resolution_s = 1e-6) {
  Times times;
  for (std::size_t i = 0; i < 5000; ++i) {
    if (i >= first && i < first + count) continue;
    times.push_back(std::round(static_cast<double>(i) / 12000 / resolution_s) * resolution_s);
  }
  return times;
}

TEST(Dropouts, AreCountedAndPlaced) {
  const Dropouts one = dropouts_in(times_without(1234, 1));
  EXPECT_EQ(one.gaps, 1U);
  EXPECT_EQ(one.missing, 1U);
  EXPECT_EQ(one.longest_after, 1233U);
  Times times = times_without(2000, 300);
  times.erase(times.begin() + 700, times.begin() + 705);
  const Dropouts two = dropouts_in(times);
  EXPECT_EQ(two.gaps, 2U);
  EXPECT_EQ(two.missing, 305U);
  EXPECT_EQ(two.longest, 300U);
  EXPECT_EQ(two.longest_after, 1994U);
}

TEST(Dropouts, AreNoneInWholeOrCoarseTimes) {
  EXPECT_EQ(dropouts_in(times_without(0, 0)).gaps, 0U);
  EXPECT_EQ(dropouts_in(times_without(0, 0, 1e-5)).gaps, 0U);
  EXPECT_EQ(dropouts_in(times_without(0, 0, 1e-4)).gaps, 0U);
  EXPECT_EQ(dropouts_in(times_without(0, 0, 1e-3)).gaps, 0U);
  EXPECT_EQ(dropouts_in(Times{}).gaps, 0U);
  EXPECT_EQ(dropouts_in(Times{0, 1, 2, 5, 6}).gaps, 0U);
}

TEST(Dropouts, AreNoneInASignal) {
  Times signal;
  for (int i = 0; i < 5000; ++i) signal.push_back(std::sin(0.7 * i));
  EXPECT_EQ(dropouts_in(signal).gaps, 0U);
}

TEST(Dropouts, OfAFileAreThoseOfItsFirstColumn) {
  const Folder folder;
  std::string text = "time,acceleration\n";
  for (const double t : times_without(1000, 40)) {
    text += std::to_string(t) + ',' + std::to_string(std::sin(1e4 * t)) + '\n';
  }
  const auto file = folder.write("run.csv", text);
  EXPECT_EQ(dropouts_of({file}, "acceleration").missing, 40U);
  EXPECT_EQ(dropouts_of({file}, "2").longest_after, 999U);
  EXPECT_EQ(dropouts_of({file}, "1").gaps, 0U) << "that is the signal";
}

TEST(Dropouts, OfOtherFilesAreNone) {
  const Folder folder;
  EXPECT_EQ(
      dropouts_of({folder.write("dates.csv", "date,x\n2024-02-24,1\n2024-02-25,2\n")}, "x").gaps,
      0U);
  EXPECT_EQ(dropouts_of({folder.write("zeros.bin", std::string(100, '\0'))}, "2").gaps, 0U);
  EXPECT_EQ(dropouts_of({folder.path() / "nowhere.csv"}, "2").gaps, 0U);
}

}  // namespace
}  // namespace piae::inspection
