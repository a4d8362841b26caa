#include "signal/sources.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "support/errors.hpp"

namespace piae::signal {
namespace {

using testing::ElementsAre;

const Counts paper{.all = 600, .test = 100, .known = 5};
constexpr Label ok_label = 0;
constexpr Label cracked_label = 1;

/// Returns three conditions: the first two known, the third tested, healthy windows from all.
DatasetInfo transfer() {
  DatasetInfo info;
  info.name = "rig";
  info.classes = {{"ok", Defect::none, 0}, {"cracked", Defect::outer, 0.5}};
  info.conditions = {
      {.name = "a", .test = false}, {.name = "b", .test = false}, {.name = "c", .known = false}};
  return info;
}

std::vector<std::size_t> counts_of(const std::vector<Source>& sources, Role role) {
  std::vector<std::size_t> counts;
  for (const Source& source : sources) counts.push_back(source.count_of(role));
  return counts;
}

TEST(Sources, ServeAllRolesWithoutConditions) {
  DatasetInfo info = transfer();
  info.conditions.clear();
  const std::vector<RecordPlace> records{{ok_label}, {cracked_label}, {cracked_label}};
  const auto faults = sources_of(info, cracked_label, records, paper, Stream("s"));
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_THAT(faults[0].records, ElementsAre(1, 2));
  EXPECT_EQ(faults[0].windows(), 600U);
  ASSERT_EQ(faults[0].shares.size(), 3U);
  EXPECT_EQ(faults[0].shares[0].role, Role::test);
  EXPECT_EQ(faults[0].shares[1].role, Role::known);
  EXPECT_EQ(faults[0].shares[2].role, Role::hidden);
  EXPECT_EQ(faults[0].shares[2].count, 495U);
  const auto sound = sources_of(info, ok_label, records, paper, Stream("s"));
  EXPECT_THAT(counts_of(sound, Role::test), ElementsAre(100));
  EXPECT_THAT(counts_of(sound, Role::healthy), ElementsAre(500));
}

TEST(Sources, TakeEachRoleFromItsConditionsInATransfer) {
  const std::vector<RecordPlace> records{{cracked_label, 0}, {cracked_label, 1}, {cracked_label, 2},
                                         {ok_label, 0},      {ok_label, 1},      {ok_label, 2}};
  const auto faults = sources_of(transfer(), cracked_label, records, paper, Stream("s"));
  EXPECT_THAT(counts_of(faults, Role::test), ElementsAre(0, 0, 100));
  EXPECT_THAT(counts_of(faults, Role::hidden), ElementsAre(0, 0, 495));
  const auto known = counts_of(faults, Role::known);
  EXPECT_EQ(known[0] + known[1], 5U);
  EXPECT_TRUE(known[0] == 2 || known[0] == 3);
  EXPECT_EQ(known[2], 0U);
  const auto sound = sources_of(transfer(), ok_label, records, paper, Stream("s"));
  EXPECT_THAT(counts_of(sound, Role::test), ElementsAre(0, 0, 100));
  const auto normal = counts_of(sound, Role::healthy);
  EXPECT_EQ(normal[0] + normal[1] + normal[2], 500U);
  EXPECT_THAT(normal, testing::Each(testing::AnyOf(166U, 167U)));
}

TEST(Sources, DrawTheSourcesThatGiveOneMore) {
  const std::vector<RecordPlace> records{
      {cracked_label, 0}, {cracked_label, 1}, {cracked_label, 2}};
  std::set<std::size_t> of_the_first;
  for (int seed = 0; seed < 20; ++seed) {
    const Stream stream("seed" + std::to_string(seed));
    of_the_first.insert(
        counts_of(sources_of(transfer(), cracked_label, records, paper, stream), Role::known)[0]);
  }
  EXPECT_THAT(of_the_first, ElementsAre(2, 3));
}

TEST(Sources, ServeAllRolesFromARecordOfEveryCondition) {
  const std::vector<RecordPlace> records{
      {ok_label, every_condition}, {cracked_label, 0}, {cracked_label, 2}};
  const auto sound = sources_of(transfer(), ok_label, records, paper, Stream("s"));
  ASSERT_EQ(sound.size(), 1U);
  EXPECT_EQ(sound[0].count_of(Role::test), 100U);
  EXPECT_EQ(sound[0].count_of(Role::healthy), 500U);
}

/// Healthy windows of each speed must be both tested and learned from.
TEST(Sources, AssignRecordsOfEveryConditionBySpeed) {
  const std::vector<RecordPlace> records{{ok_label, every_condition, 900},
                                         {ok_label, every_condition, 600},
                                         {ok_label, every_condition, 900},
                                         {cracked_label, 0, 600},
                                         {cracked_label, 2, 900}};
  const auto sound = sources_of(transfer(), ok_label, records, paper, Stream("s"));
  ASSERT_EQ(sound.size(), 2U);
  EXPECT_EQ(sound[0].shaft_speed_rpm, 600);
  EXPECT_EQ(sound[1].shaft_speed_rpm, 900);
  EXPECT_THAT(sound[0].records, ElementsAre(1));
  EXPECT_THAT(sound[1].records, ElementsAre(0, 2));
  EXPECT_THAT(counts_of(sound, Role::test), ElementsAre(50, 50));
  EXPECT_THAT(counts_of(sound, Role::healthy), ElementsAre(250, 250));
  // Without conditions, records differ in speed by chance.
  DatasetInfo info = transfer();
  info.conditions.clear();
  const std::vector<RecordPlace> same{{ok_label, every_condition, 900},
                                      {ok_label, every_condition, 905}};
  EXPECT_EQ(sources_of(info, ok_label, same, paper, Stream("s")).size(), 1U);
}

TEST(Sources, IgnoreRolesWithoutWindows) {
  const Counts nothing_known{.all = 595, .test = 100, .known = 0};
  const std::vector<RecordPlace> records{{cracked_label, 2}};  // tested, not known
  const auto faults = sources_of(transfer(), cracked_label, records, nothing_known, Stream("s"));
  ASSERT_EQ(faults.size(), 1U);
  ASSERT_EQ(faults[0].shares.size(), 2U);
  EXPECT_EQ(faults[0].count_of(Role::test), 100U);
  EXPECT_EQ(faults[0].count_of(Role::hidden), 495U);
}

TEST(Sources, RefuseRolesWithoutARecord) {
  const std::vector<RecordPlace> records{{cracked_label, 0}, {cracked_label, 1}};
  EXPECT_ERROR(sources_of(transfer(), cracked_label, records, paper, Stream("s")), Exit::bad_input,
               "data set rig, class cracked: has no record for role A");
}

}  // namespace
}  // namespace piae::signal
