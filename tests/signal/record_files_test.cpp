#include "signal/record_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "support/folder.hpp"

namespace piae::signal {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(RecordFiles, AreInNumericOrder) {
  std::vector<std::string> names{"a10", "a9", "b1", "a010",  "a2b",
                                 "a2",  "A1", "a",  "a2b10", "a2b9"};
  std::ranges::sort(names, naturally_less);
  EXPECT_THAT(names,
              ElementsAre("A1", "a", "a2", "a2b", "a2b9", "a2b10", "a9", "a010", "a10", "b1"));
  std::vector<std::string> times{"2004.02.12.11.02.39", "2004.02.12.10.52.39", "2003.11.30.1"};
  std::ranges::sort(times, naturally_less);
  EXPECT_THAT(times, ElementsAre("2003.11.30.1", "2004.02.12.10.52.39", "2004.02.12.11.02.39"));
}

TEST(RecordFiles, CompareIrreflexively) {
  for (const char* name : {"", "7", "a07", "a7b"}) EXPECT_FALSE(naturally_less(name, name)) << name;
  EXPECT_TRUE(naturally_less("123456789012345678901234567890", "1234567890123456789012345678901"));
}

TEST(RecordFiles, ExpandPatterns) {
  const Folder folder;
  for (const char* file : {"one/acc_2.csv", "one/acc_10.csv", "one/temp_1.csv", "one/.acc_3.csv",
                           "two/acc_1.csv", "two/acc_[1].csv", "two/deeper/acc_9.csv"}) {
    folder.write(file, "1\n");
  }
  const auto of = [&](const std::string& pattern) { return files_of({pattern}, folder.path()); };
  EXPECT_THAT(of("one/acc_*.csv"), ElementsAre("one/acc_2.csv", "one/acc_10.csv"));
  EXPECT_THAT(of("*/acc_?.csv"), ElementsAre("one/acc_2.csv", "two/acc_1.csv"));
  EXPECT_THAT(of("two/acc_[*].csv"), ElementsAre("two/acc_[1].csv"));
  EXPECT_THAT(of("one/.acc*"), ElementsAre("one/.acc_3.csv"));
  EXPECT_THAT(of("tw*"), IsEmpty());  // a folder
  EXPECT_THAT(of("three/*"), IsEmpty());
  EXPECT_THAT(of("*.csv"), IsEmpty());  // a star stops at a slash
}

TEST(RecordFiles, KeepTheOrderOfNames) {
  const Folder folder;
  folder.write("b1", "1\n");
  folder.write("b2", "1\n");
  EXPECT_THAT(files_of({"z.csv", "b*", "a.csv"}, folder.path()),
              ElementsAre("z.csv", "b1", "b2", "a.csv"));
}

}  // namespace
}  // namespace piae::signal
