#include "signal/described_conditions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "signal/conditions_text.hpp"
#include "support/description_text.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::signal {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Description described(const std::string& text) {
  const Folder folder;
  return read_description(folder.write("rig.toml", text));
}

std::vector<std::string> names_of_records(const Description& d) {
  std::vector<std::string> names;
  for (const RecordSource& record : d.records) names.push_back(record.name);
  return names;
}

TEST(DescribedConditions, AreTheConditionsOfRecordsWithTheirSpeeds) {
  const Description d = described(two_speeds);
  EXPECT_THAT(d.info.conditions,
              ElementsAre(Condition{.name = "900 rpm", .shaft_speed_rpm = 900},
                          Condition{.name = "1200 rpm", .shaft_speed_rpm = 1195}));
  EXPECT_FALSE(is_transfer(d.info.conditions));
  EXPECT_THAT(names_of_records(d),
              ElementsAre("cracked-1200-rpm", "cracked-900-rpm", "ok-1200-rpm", "ok-900-rpm"));
}

TEST(DescribedConditions, AreEmptyIfNoRecordHasOne) {
  std::string text = replaced(two_speeds, "condition = \"900 rpm\"\n", "");
  text = replaced(text, "condition = \"900 rpm\"\n", "");
  text = replaced(text, "condition = \"1200 rpm\"\n", "");
  text = replaced(text, "condition = \"1200 rpm\"\n", "");
  const Description d = described(text);
  EXPECT_THAT(d.info.conditions, IsEmpty());
  EXPECT_THAT(names_of_records(d), ElementsAre("cracked-01", "cracked-02", "ok-01", "ok-02"));
}

TEST(DescribedConditions, GetTheirUseFromTheTransferTable) {
  const Description d = described(two_speeds + from_900_to_1200);
  ASSERT_EQ(d.info.conditions.size(), 2U);
  const Condition& known = d.info.conditions[0];
  EXPECT_TRUE(known.known && !known.test && known.healthy);
  const Condition& test = d.info.conditions[1];
  EXPECT_TRUE(!test.known && test.test && test.healthy);
  EXPECT_TRUE(is_transfer(d.info.conditions));
}

TEST(DescribedConditions, MayLimitHealthyWindows) {
  const Description d = described(two_speeds + from_900_to_1200 + "healthy = [\"1200 rpm\"]\n");
  EXPECT_FALSE(d.info.conditions[0].healthy);
  EXPECT_TRUE(d.info.conditions[1].healthy);
}

TEST(DescribedConditions, HaveRecordsOfTheirOwnSpeeds) {
  const Description d = described(
      replaced(two_speeds, "shaft_speed_rpm = 1190", "shaft_speed_rpm = 1290") + from_900_to_1200);
  EXPECT_DOUBLE_EQ(d.info.conditions[1].shaft_speed_rpm, 1245);
  EXPECT_THAT(d.records, testing::Contains(testing::Field(&RecordSource::shaft_speed_rpm, 1290)));
}

TEST(DescribedConditions, LeaveOutRecordsOfUnusedConditions) {
  const std::string third =
      "[[record]]\nclass = \"ok\"\ncondition = \"600 rpm\"\nfile = \"e.csv\"\nvariable = \"1\"\n"
      "sample_rate_hz = 8000\n";
  const Description d = described(two_speeds + third + from_900_to_1200);
  EXPECT_EQ(d.info.conditions.size(), 2U);
  EXPECT_EQ(d.records.size(), 4U);
}

TEST(DescribedConditions, GiveAClassTheMeanOfItsKnownSizes) {
  std::string text = replaced(two_speeds, "defect_size_mm = 0.5\n", "");
  text = replaced(text, "file = \"c.csv\"", "file = \"c.csv\"\ndefect_size_mm = 0.3");
  text = replaced(text, "file = \"d.csv\"", "file = \"d.csv\"\ndefect_size_mm = 0.6");
  EXPECT_DOUBLE_EQ(described(text).info.classes[1].defect_size_mm, 0.45);
  const Description transfer = described(text + from_900_to_1200);
  EXPECT_DOUBLE_EQ(transfer.info.classes[1].defect_size_mm, 0.3);
  EXPECT_EQ(transfer.records[0].defect_size_mm, 0.6);
}

struct Refused {
  const char* from;
  const char* to;
  const char* message;
};

class RefusedConditions : public testing::TestWithParam<Refused> {};

TEST_P(RefusedConditions, GiveOneLineWithFileLineAndKey) {
  const Folder folder;
  const Refused& refused = GetParam();
  const std::string text =
      replaced(two_speeds + from_900_to_1200 + "# end\n", refused.from, refused.to);
  const auto file = folder.write("rig.toml", text);
  EXPECT_ERROR(read_description(file), Exit::bad_input, file.string() + ", line ");
  EXPECT_ERROR(read_description(file), Exit::bad_input, refused.message);
}

INSTANTIATE_TEST_SUITE_P(
    All, RefusedConditions,
    testing::Values(
        Refused{"known = [\"900 rpm\"]", "known = [\"700 rpm\"]",
                "transfer.known names '700 rpm', which is not the condition of any record; records "
                "have 900 rpm, 1200 rpm"},
        Refused{"test = [\"1200 rpm\"]", "test = [\"900 rpm\"]",
                "transfer.test names '900 rpm', which is in known, too"},
        Refused{"test = [\"1200 rpm\"]", "test = [\"1200 rpm\", \"1200 rpm\"]",
                "transfer.test names '1200 rpm' twice"},
        Refused{"test = [\"1200 rpm\"]", "test = []", "transfer.test must be a list of one"},
        Refused{"test = [\"1200 rpm\"]", "test = \"1200 rpm\"", "transfer.test must be a list"},
        Refused{"test = [\"1200 rpm\"]", "", "transfer.test is missing"},
        Refused{"# end", "tested = 1", "transfer.tested is unknown; write test"},
        Refused{"# end", "healthy = [\"0 HP\"]", "transfer.healthy names '0 HP'"},
        Refused{"class = \"cracked\"\ncondition = \"900 rpm\"",
                "class = \"cracked\"\ncondition = \"1200 rpm\"",
                "transfer.known is 900 rpm, but class cracked has no record there"},
        Refused{"class = \"cracked\"\ncondition = \"1200 rpm\"",
                "class = \"cracked\"\ncondition = \"900 rpm\"",
                "transfer.test is 1200 rpm, but class cracked has no record there"},
        Refused{"class = \"cracked\"\ncondition = \"1200 rpm\"", "class = \"cracked\"",
                "transfer.known needs a condition for each fault record, but class cracked has a "
                "record without one"},
        Refused{
            "shaft_speed_rpm = 1190", "shaft_speed_rpm = 1330",
            "record has condition '1200 rpm' at 1200 and at 1330 rpm; the speeds of a condition "
            "may differ by 10 %"},
        Refused{"class = \"ok\"\ncondition = \"1200 rpm\"",
                "class = \"ok\"\ncondition = \"900 rpm\"",
                "transfer.test names '1200 rpm', but there is no record of class ok"},
        Refused{"class = \"ok\"\ncondition = \"900 rpm\"",
                "class = \"ok\"\ncondition = \"1200 rpm\"",
                "transfer.healthy is known and test together by default, but for '900 rpm' there "
                "is no record of class ok"},
        Refused{"condition = \"900 rpm\"", "condition = [\"900 rpm\", \"1200 rpm\"]",
                "record.condition must be a text"},
        Refused{"condition = \"900 rpm\"", "condition = \"900\\trpm\"",
                "record.condition holds a control character"},
        Refused{"condition = \"900 rpm\"", "condition = \"900 rpm \"",
                "record.condition '900 rpm ' may hold letters"},
        Refused{"condition = \"900 rpm\"", "condition = \"900 rpm\"\nshaft_speed_rpm = 0",
                "record.shaft_speed_rpm must be from 0.01"},
        Refused{"condition = \"900 rpm\"", "condition = \"900 rpm\"\ndefect_size_mm = 1",
                "record.defect_size_mm is not possible if the defect is 'none'"},
        Refused{"file = \"c.csv\"", "file = \"c.csv\"\ndefect_size_mm = 90",
                "record.defect_size_mm is refused: defect size 90"},
        Refused{"# end", "[split]\nwindows = 3", "split.windows is unknown; known keys are window"},
        Refused{"# end", "[split]\nwindows_per_class = 3", "; write windows-per-class"},
        Refused{"# end", "[split]\nwindow = 0", "split.window must be from 1"},
        Refused{"# end", "[split]\nknown-per-class = -1", "split.known-per-class must be from 0"},
        Refused{
            "# end", "[split]\nknown-per-class = 0",
            "transfer.known names conditions with known faults, but split.known-per-class is 0"},
        Refused{"# end", "[split]\nwindow = \"long\"", "split.window must be a whole number"}));

TEST(DescribedConditions, MayHaveNoKnownFault) {
  const Folder folder;
  const Description description =
      read_description(folder.write("rig.toml", two_speeds + "[split]\nknown-per-class = 0\n"));
  EXPECT_EQ(description.info.conditions.size(), 2U);
}

/// Healthy windows of one speed, faults of another.
TEST(DescribedConditions, MayHaveHealthyWindowsOfAnotherConditionAlone) {
  const Description d = described(two_speeds +
                                  "[split]\nknown-per-class = 0\n[transfer]\ntest = "
                                  "[\"900 rpm\"]\nhealthy = [\"1200 rpm\"]\n");
  ASSERT_EQ(d.info.conditions.size(), 2U);
  const Condition& test = d.info.conditions[0];
  EXPECT_TRUE(test.known && test.test && !test.healthy);
  const Condition& healthy = d.info.conditions[1];
  EXPECT_TRUE(!healthy.known && !healthy.test && healthy.healthy);
  EXPECT_FALSE(is_transfer(d.info.conditions));
}

/// Healthy records at several speeds do not need a condition for each.
TEST(DescribedConditions, AllowOwnSpeedsWithoutACondition) {
  const Folder folder;
  const std::string text = replaced(two_speeds, "condition = \"1200 rpm\"\nshaft_speed_rpm = 1200",
                                    "shaft_speed_rpm = 1200");
  const Description description = read_description(folder.write("rig.toml", text));
  const auto healthy = std::ranges::find(description.records, "b.csv", &RecordSource::file_text);
  ASSERT_NE(healthy, description.records.end());
  EXPECT_EQ(healthy->condition, "");
  EXPECT_EQ(healthy->shaft_speed_rpm, 1200);
}

TEST(DescribedConditions, AreNeededForATransfer) {
  const Folder folder;
  std::string text = two_speeds;
  for (const char* speed : {"900", "900", "1200", "1200"}) {
    text = replaced(text, "condition = \"" + std::string(speed) + " rpm\"\n", "");
  }
  EXPECT_ERROR(read_description(folder.write("rig.toml", text + from_900_to_1200)), Exit::bad_input,
               "transfer.known names conditions, but no record has one");
}

}  // namespace
}  // namespace piae::signal
