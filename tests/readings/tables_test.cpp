#include "readings/tables.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace piae::readings {
namespace {

using testing::HasSubstr;

Readings two_readings() {
  return resolve({.dataset = "cwru",
                  .base = {"batches=mixed"},
                  .readings = {"batches=class"},
                  .ratios = {"10to1"},
                  .seeds = {"100 101"}});
}

std::vector<Row> rows() {
  const Readings readings = two_readings();
  std::vector<Row> all =
      rows_of(readings.readings[0], {{{"accuracy", "10to1", 60.0}, {"alpha", "", 1.5}},
                                     {{"accuracy", "10to1", 62.0}, {"alpha", "", 1.5}}});
  const std::vector<Row> other =
      rows_of(readings.readings[1], {{{"accuracy", "10to1", 50.0}, {"stiffness", "", 2e8}}});
  all.insert(all.end(), other.begin(), other.end());
  return all;
}

TEST(ReadingTables, ShowMeanAndDeviationOverTheSeeds) {
  const std::string text = csv("cwru", rows());
  EXPECT_THAT(text, HasSubstr("dataset,reading,quantity,ratio,seeds,mean,std\n"));
  EXPECT_THAT(text, HasSubstr("cwru,base,accuracy,10to1,2,61,1.41421\n"));
  EXPECT_THAT(text, HasSubstr("cwru,base,alpha,,2,1.5,0\n"));
  EXPECT_THAT(text, HasSubstr("cwru,batches=class,accuracy,10to1,1,50,\n"));
}

TEST(ReadingTables, ShowADashForAnUnknownQuantity) {
  const std::string text = report::markdown(document(two_readings(), rows()));
  EXPECT_THAT(text, HasSubstr("61.0 ± 1.4"));
  EXPECT_THAT(text, HasSubstr("base is batches=mixed"));
  EXPECT_THAT(text, testing::ContainsRegex("batches=class +\\| +– \\| +– \\| +200"));
}

TEST(ReadingTables, EndWithThePublishedValues) {
  std::vector<Row> all = rows();
  const Readings readings = two_readings();
  const report::Published published(std::filesystem::path(PIAE_SOURCE) / "results/published");
  const std::vector<Row> of_paper = published_rows(readings.grid, published);
  all.insert(all.end(), of_paper.begin(), of_paper.end());
  EXPECT_THAT(csv("cwru", all), HasSubstr("cwru,published,accuracy,10to1,1,85.4,\n"));
  EXPECT_THAT(report::markdown(document(readings, all)),
              testing::ContainsRegex("as published +\\| +85.4 \\| +–"));
}

TEST(ReadingTables, HaveNoPublishedRowForOtherDataSets) {
  Readings readings = two_readings();
  readings.grid.dataset = "rig";
  EXPECT_THAT(published_rows(readings.grid, report::Published()), testing::IsEmpty());
  EXPECT_THAT(report::markdown(document(readings, rows())),
              testing::Not(HasSubstr("as published")));
}

}  // namespace
}  // namespace piae::readings
