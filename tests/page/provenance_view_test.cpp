#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "page/cells_view.hpp"

namespace piae::page {
namespace {

using testing::HasSubstr;
using testing::Not;

DatasetContents made_from(std::size_t files) {
  DatasetContents dataset;
  dataset.name = "rig";
  dataset.records_digest = "efb1";
  for (std::size_t i = 0; i < files; ++i) {
    dataset.records.push_back({.file = "acc_" + std::to_string(i) + ".csv", .digest = "d"});
  }
  return dataset;
}

TEST(ProvenanceView, NamesEveryFileOfADataSet) {
  const std::string view = provenance_view({made_from(100)}).text();
  EXPECT_THAT(view, HasSubstr("acc_0.csv"));
  EXPECT_THAT(view, HasSubstr("acc_99.csv"));
  EXPECT_THAT(view, Not(HasSubstr("more file")));
}

TEST(ProvenanceView, CountsFilesBeyondAHundred) {
  const std::string view = provenance_view({made_from(2803)}).text();
  EXPECT_THAT(view, HasSubstr("acc_99.csv"));
  EXPECT_THAT(view, Not(HasSubstr("acc_100.csv")));
  EXPECT_THAT(view, HasSubstr("2703 more files"));
}

}  // namespace
}  // namespace piae::page
