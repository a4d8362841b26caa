#include "formats/exported.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "formats/exported_windows.hpp"
#include "support/errors.hpp"

namespace piae::formats {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

template <class Values>
Values values_of(const std::vector<Fact>& facts, const std::string& name) {
  const auto found = std::ranges::find(facts, name, &Fact::name);
  if (found == facts.end()) throw std::logic_error("no fact " + name);
  return std::get<Values>(found->values);
}

std::vector<std::string> names_of(const std::vector<Fact>& facts) {
  std::vector<std::string> names;
  for (const Fact& fact : facts) names.push_back(fact.name);
  return names;
}

TEST(Select, TakesTheFirstWindowsOfTheNamedClasses) {
  EXPECT_THAT(select(four_windows(), {}, 0).rows, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(select(four_windows(), {}, 1).rows, ElementsAre(0, 2));
  EXPECT_THAT(select(four_windows(), {"OR"}, 0).rows, ElementsAre(2, 3));
  const Exported one = select(four_windows(), {"OR"}, 1);
  EXPECT_THAT(one.rows, ElementsAre(2));
  EXPECT_THAT(one.windows.samples, ElementsAre(16777216, -0.0F));
  EXPECT_THAT(one.windows.start_angle_rad, ElementsAre(6.25));
}

TEST(Select, ListsTheClassesIfOneIsUnknown) {
  EXPECT_ERROR(select(four_windows(), {"OR", "XR"}, 0), Exit::usage,
               "--class XR: the data set rig has no such class; it has healthy, IR, OR");
  EXPECT_ERROR(select(four_windows(), {"healthy"}, 0), Exit::bad_input, "no window of healthy");
  signal::WindowSet none = four_windows();
  none.labels.clear();
  none.samples.clear();
  EXPECT_ERROR(select(none, {}, 0), Exit::bad_input, "holds no window");
}

TEST(Facts, HoldTheKnownValuesOfEachWindow) {
  const Facts facts = facts_of(exported_windows());
  EXPECT_THAT(values_of<Texts>(facts.of_all, "dataset"), ElementsAre("rig"));
  EXPECT_THAT(values_of<Texts>(facts.of_all, "role"), ElementsAre("E"));
  EXPECT_THAT(values_of<Texts>(facts.of_all, "method"), ElementsAre("smote"));
  EXPECT_THAT(values_of<Numbers>(facts.of_all, "sample_rate_hz"), ElementsAre(12000));
  EXPECT_THAT(values_of<Numbers>(facts.of_all, "unit_m_per_s2"), ElementsAre(9.80665));
  const auto& each = facts.of_each;
  EXPECT_THAT(values_of<Numbers>(each, "window"), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(values_of<Texts>(each, "class_name"), ElementsAre("IR", "IR", "OR", "OR"));
  EXPECT_THAT(values_of<Texts>(each, "defect"), ElementsAre("inner", "inner", "outer", "outer"));
  EXPECT_THAT(values_of<Numbers>(each, "defect_size_mm"), ElementsAre(0.25, 0.25, 0.5, 0.5));
  EXPECT_THAT(values_of<Numbers>(each, "shaft_speed_rpm"), ElementsAre(900, 901.5, 900, 900));
  EXPECT_THAT(values_of<Texts>(each, "condition"),
              ElementsAre("900 rpm", "every", "900 rpm", "900 rpm"));
  EXPECT_THAT(values_of<Numbers>(each, "k_n_per_m"), ElementsAre(1e8, 1.5e8, 2e8, 0));
  EXPECT_THAT(values_of<Numbers>(each, "c_ns_per_m"), ElementsAre(500, 0.1, 1, 2));
  EXPECT_THAT(values_of<Numbers>(each, "start_angle_rad"), ElementsAre(0, 1.5, 6.25, 3));
  EXPECT_THAT(values_of<Lists>(each, "parents"),
              ElementsAre(ElementsAre(0, 3), ElementsAre(1), IsEmpty(), ElementsAre(12)));
  EXPECT_EQ(values_of<Lists>(each, "strikes_s"), four_windows().impact_times_s);
}

TEST(Facts, LeaveOutUnknownValues) {
  signal::WindowSet cut = four_windows();
  cut.parameters.clear();
  cut.condition.clear();
  cut.shaft_speed_rpm.clear();
  cut.start_angle_rad.clear();
  cut.parents.clear();
  cut.impact_times_s.clear();
  cut.record_names = {"a", "b"};
  cut.record = {0, 0, 1, 1};
  cut.first_sample = {0, 100, 5000000000, 200};
  Exported exported = select(cut, {}, 0);
  exported.role = "D";
  const Facts facts = facts_of(exported);
  EXPECT_THAT(names_of(facts.of_all),
              ElementsAre("dataset", "role", "sample_rate_hz", "unit_m_per_s2"));
  EXPECT_THAT(names_of(facts.of_each),
              ElementsAre("window", "class_name", "defect", "defect_size_mm", "shaft_speed_rpm",
                          "record", "first_sample"));
  EXPECT_THAT(values_of<Numbers>(facts.of_each, "shaft_speed_rpm"),
              ElementsAre(1797, 1797, 1797, 1797));
  EXPECT_THAT(values_of<Texts>(facts.of_each, "record"), ElementsAre("a", "a", "b", "b"));
  EXPECT_THAT(values_of<Numbers>(facts.of_each, "first_sample"),
              ElementsAre(0, 100, 5000000000, 200));
}

}  // namespace
}  // namespace piae::formats
