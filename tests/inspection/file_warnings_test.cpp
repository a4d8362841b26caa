#include "inspection/file_warnings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace piae::inspection {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> warnings_of_files(const std::vector<FileCheck>& files) {
  RecordCheck record;
  record.source.name = "healthy";
  record.source.files = {"run/acc_*.csv"};
  record.source.variable = "5";
  record.files = files;
  std::vector<std::string> lines;
  add_odd_files(record, lines);
  return lines;
}

TEST(FileWarnings, AcceptSimilarFiles) {
  EXPECT_THAT(warnings_of_files({{"a", 2560, 6}, {"b", 2560, 6}, {"c", 2560, 6}}), IsEmpty());
  EXPECT_THAT(warnings_of_files({{"a", 2560, 6}}), IsEmpty());
  EXPECT_THAT(warnings_of_files({}), IsEmpty());
}

TEST(FileWarnings, NameAShorterFile) {
  EXPECT_THAT(
      warnings_of_files({{"a", 2560, 6}, {"b", 1999, 6}, {"c", 2560, 6}}),
      ElementsAre("healthy (run/acc_*.csv, variable 5): most of its 3 files have 2560 "
                  "samples, but b has 1999; they may be cut off or recorded with other settings"));
}

TEST(FileWarnings, NameAndCountFilesWithOtherColumns) {
  std::vector<FileCheck> files(12, {"a", 10, 6});
  for (int i = 0; i < 5; ++i) files[2 * i] = {"b" + std::to_string(i), 10, 5};
  EXPECT_THAT(warnings_of_files(files),
              ElementsAre("healthy (run/acc_*.csv, variable 5): most of its 12 files have 6 "
                          "columns, but b0 has 5, b1 has 5, b2 has 5, and 2 more differ; the "
                          "variable may be another channel there"));
}

}  // namespace
}  // namespace piae::inspection
