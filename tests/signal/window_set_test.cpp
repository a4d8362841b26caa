#include "signal/window_set.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "signal/counting.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::signal {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

WindowSet empty_set() {
  WindowSet set;
  set.info = counting_recordings(10).info;
  set.length = 2;
  return set;
}

/// Returns three cut windows of two samples, with their true parameters.
WindowSet cut_set() {
  WindowSet set = empty_set();
  set.samples = {1, 2, 3, 4, 5, 6};
  set.labels = {0, 2, 0};
  set.record_names = {"N", "R"};
  set.record = {0, 1, 0};
  set.first_sample = {10, 20, 30};
  set.parameters = {{1, 2}, {3, 4}, {5, 6}};
  return set;
}

WindowSet generated_set() {
  WindowSet set = empty_set();
  set.samples = {7, 8};
  set.labels = {1};
  set.parameters = {{7, 8}};
  return set;
}

std::filesystem::path save(const Folder& folder, const WindowSet& set) {
  artefact::Writer writer("windows");
  write(writer, set);
  writer.save(folder / "A.h5", {});
  return folder / "A.h5";
}

WindowSet load_set(const std::filesystem::path& file) {
  return read_window_set(artefact::Reader(file, "windows"));
}

TEST(WindowSet, FindsTheWindowsOfALabel) {
  const WindowSet set = cut_set();
  EXPECT_THAT(set.indices_of(0), ElementsAre(0, 2));
  EXPECT_THAT(set.indices_of(1), IsEmpty());
  EXPECT_EQ(set.count_of(0), 2U);
  EXPECT_EQ(set.count_of(1), 0U);
  EXPECT_THAT(set.window(1), ElementsAre(3, 4));
}

TEST(WindowSet, IsReadBack) {
  const Folder folder;
  const WindowSet out = load_set(save(folder, cut_set()));
  EXPECT_EQ(out.length, 2U);
  EXPECT_EQ(out.samples, cut_set().samples);
  EXPECT_EQ(out.labels, cut_set().labels);
  EXPECT_EQ(out.record_names, cut_set().record_names);
  EXPECT_EQ(out.record, cut_set().record);
  EXPECT_EQ(out.first_sample, cut_set().first_sample);
  ASSERT_EQ(out.parameters.size(), 3U);
  EXPECT_EQ(out.parameters[1].stiffness_n_per_m, 3);
  EXPECT_EQ(out.parameters[1].damping_ns_per_m, 4);
}

/// Returns the cut set with condition, speed and defect size of each window.
WindowSet set_of_conditions() {
  WindowSet set = cut_set();
  set.info.conditions = {{.name = "900 rpm", .shaft_speed_rpm = 900},
                         {.name = "1200 rpm", .shaft_speed_rpm = 1200}};
  set.condition = {1, 0, every_condition};
  set.shaft_speed_rpm = {1201, 899, 1000};
  set.defect_size_mm = {0, 0.3, 0};
  return set;
}

TEST(WindowSet, IsReadBackWithConditions) {
  const Folder folder;
  const WindowSet in = set_of_conditions();
  const WindowSet out = load_set(save(folder, in));
  EXPECT_EQ(out.info.conditions, in.info.conditions);
  EXPECT_EQ(out.condition, in.condition);
  EXPECT_EQ(out.shaft_speed_rpm, in.shaft_speed_rpm);
  EXPECT_EQ(out.defect_size_mm, in.defect_size_mm);
}

TEST(WindowSet, KeepsConditionsWhileAllWindowsHaveThem) {
  WindowSet set = set_of_conditions();
  set.append(set_of_conditions(), 1);
  EXPECT_THAT(set.condition, ElementsAre(1, 0, every_condition, 0));
  EXPECT_THAT(set.shaft_speed_rpm, ElementsAre(1201, 899, 1000, 899));
  set.append(cut_set(), 0);
  EXPECT_THAT(set.condition, IsEmpty());
  EXPECT_THAT(set.shaft_speed_rpm, IsEmpty());
  EXPECT_THAT(set.defect_size_mm, IsEmpty());
}

TEST(WindowSet, IsRefusedWithInvalidConditions) {
  const Folder folder;
  const auto refused = [&](auto spoil, const std::string& message) {
    WindowSet set = set_of_conditions();
    spoil(set);
    EXPECT_ERROR(load_set(save(folder, set)), Exit::bad_input, message);
  };
  refused([](WindowSet& s) { s.condition[0] = 2; }, "/condition holds condition 2 of 2");
  refused([](WindowSet& s) { s.condition[0] = -2; }, "/condition holds condition -2 of 2");
  refused([](WindowSet& s) { s.condition.pop_back(); }, "/condition");
  refused([](WindowSet& s) { s.shaft_speed_rpm[1] = 0; }, "/shaft_speed_rpm");
  refused([](WindowSet& s) { s.defect_size_mm[1] = -1; }, "/defect_size_mm");
  refused([](WindowSet& s) { s.info.conditions[1].name = "900 rpm"; }, "has 900 rpm twice");
  refused([](WindowSet& s) { s.info.conditions[1].name = "a/b"; }, "/conditions/name");
  refused([](WindowSet& s) { s.info.conditions[1].shaft_speed_rpm = -1; },
          "/conditions/shaft_speed_rpm");
  refused([](WindowSet& s) { s.info.conditions[0].test = s.info.conditions[1].test = false; },
          "/conditions/test is 0 for all conditions");
}

TEST(WindowSet, IsReadBackIfGeneratedOrEmpty) {
  const Folder folder;
  const WindowSet generated = load_set(save(folder, generated_set()));
  EXPECT_THAT(generated.record, IsEmpty());
  EXPECT_EQ(generated.parameters.size(), 1U);
  EXPECT_EQ(load_set(save(folder, empty_set())).size(), 0U);
}

TEST(WindowSet, AppendsWindowsWithAllFacts) {
  WindowSet set = empty_set();
  set.append(cut_set(), 1);
  set.append(cut_set(), 2);
  set.append(cut_set(), 1);
  EXPECT_THAT(set.labels, ElementsAre(2, 0, 2));
  EXPECT_THAT(set.samples, ElementsAre(3, 4, 5, 6, 3, 4));
  EXPECT_THAT(set.record_names, ElementsAre("R", "N"));
  EXPECT_THAT(set.record, ElementsAre(0, 1, 0));
  EXPECT_THAT(set.first_sample, ElementsAre(20, 30, 20));
  EXPECT_EQ(set.parameters[1].stiffness_n_per_m, 5);
}

TEST(WindowSet, KeepsCommonFactsOfCutAndGeneratedWindows) {
  WindowSet set = cut_set();
  set.append(generated_set(), 0);
  set.append(cut_set(), 0);
  EXPECT_EQ(set.size(), 5U);
  EXPECT_THAT(set.record, IsEmpty());
  EXPECT_THAT(set.first_sample, IsEmpty());
  EXPECT_THAT(set.record_names, IsEmpty());
  EXPECT_EQ(set.parameters.size(), 5U);
}

TEST(WindowSet, KeepsTheImpactTimesOfWindows) {
  const Folder folder;
  const auto struck = [&](const std::vector<std::vector<double>>& impact_times_s) {
    WindowSet set = generated_set();
    set.impact_times_s = impact_times_s;
    return load_set(save(folder, set));
  };
  const WindowSet some = generated_set();
  const double end_s = static_cast<double>(some.length) / some.info.sample_rate_hz;
  std::vector<std::vector<double>> impact_times_s(some.size());
  impact_times_s[0] = {0, 0.25 * end_s, 0.5 * end_s};
  impact_times_s.back().push_back(0.9 * end_s);
  EXPECT_EQ(struck(impact_times_s).impact_times_s, impact_times_s);
  impact_times_s[0] = {0.5 * end_s, 0.25 * end_s};
  EXPECT_ERROR(struck(impact_times_s), Exit::bad_input, "/strikes/time_s holds an impact");
  impact_times_s[0] = {end_s};
  EXPECT_ERROR(struck(impact_times_s), Exit::bad_input, "/strikes/time_s holds an impact");
  impact_times_s[0] = {-0.1 * end_s};
  EXPECT_ERROR(struck(impact_times_s), Exit::bad_input, "/strikes/time_s holds an impact");
  impact_times_s[0] = {0};
  impact_times_s.push_back({0});
  EXPECT_ERROR(struck(impact_times_s), Exit::bad_input, "/strikes/window does not name windows");
}

/// Returns the cut set as if made from two known windows, from one and from none.
WindowSet set_with_parents() {
  WindowSet set = cut_set();
  set.parents = {{4, 0}, {2}, {}};
  set.start_angle_rad = {0, 3, 6.25};
  return set;
}

TEST(WindowSet, KeepsTheParentsOfWindows) {
  const Folder folder;
  const WindowSet out = load_set(save(folder, set_with_parents()));
  EXPECT_EQ(out.parents, set_with_parents().parents);
  EXPECT_EQ(out.start_angle_rad, set_with_parents().start_angle_rad);
  EXPECT_THAT(load_set(save(folder, cut_set())).parents, IsEmpty());
  EXPECT_THAT(load_set(save(folder, cut_set())).start_angle_rad, IsEmpty());
}

TEST(WindowSet, KeepsParentsWhileAllWindowsHaveThem) {
  WindowSet set = set_with_parents();
  set.append(set_with_parents(), 1);
  EXPECT_THAT(set.parents,
              ElementsAre(ElementsAre(4, 0), ElementsAre(2), IsEmpty(), ElementsAre(2)));
  EXPECT_THAT(set.start_angle_rad, ElementsAre(0, 3, 6.25, 3));
  set.append(cut_set(), 0);
  EXPECT_THAT(set.parents, IsEmpty());
  EXPECT_THAT(set.start_angle_rad, IsEmpty());
}

TEST(WindowSet, IsRefusedWithInvalidParentsOrAngles) {
  const Folder folder;
  const auto refused = [&](auto spoil, const std::string& message) {
    WindowSet set = set_with_parents();
    spoil(set);
    EXPECT_ERROR(load_set(save(folder, set)), Exit::bad_input, message);
  };
  refused([](WindowSet& s) { s.parents[1] = {-1}; }, "/parents/known holds -1");
  refused([](WindowSet& s) { s.parents.push_back({0}); },
          "/parents/window does not name windows in order");
  refused([](WindowSet& s) { s.start_angle_rad[1] = 6.3; }, "/start_angle_rad");
  refused([](WindowSet& s) { s.start_angle_rad[1] = -0.1; }, "/start_angle_rad");
  refused([](WindowSet& s) { s.start_angle_rad.pop_back(); }, "/start_angle_rad");
}

TEST(WindowSet, RefusesWindowsOfAnotherLength) {
  WindowSet set = empty_set();
  set.length = 3;
  EXPECT_THROW(set.append(cut_set(), 0), std::logic_error);
}

TEST(WindowSet, IsRefusedIfItsPartsDoNotMatch) {
  const Folder folder;
  const auto with = [&](const auto& change) {
    WindowSet set = cut_set();
    change(set);
    return load_set(save(folder, set));
  };
  EXPECT_ERROR(with([](auto& s) { s.labels[1] = 3; }), Exit::bad_input, "/labels holds label 3");
  EXPECT_ERROR(with([](auto& s) { s.labels[1] = -1; }), Exit::bad_input, "/labels holds label -1");
  EXPECT_ERROR(with([](auto& s) { s.record[1] = 2; }), Exit::bad_input, "points to record 2 of 2");
  EXPECT_ERROR(with([](auto& s) { s.record.pop_back(); }), Exit::bad_input,
               "/record/index does not match");
  EXPECT_ERROR(with([](auto& s) { s.first_sample.pop_back(); }), Exit::bad_input,
               "/first_sample does not match");
  EXPECT_ERROR(with([](auto& s) { s.first_sample[0] = -5; }), Exit::bad_input, "holds -5");
  EXPECT_ERROR(with([](auto& s) {
                 s.samples.clear();
                 s.length = 0;
               }),
               Exit::bad_input, "/windows has windows of 0 samples");
}

TEST(WindowSet, OrdersWindowsByRecordAndTime) {
  WindowSet set = empty_set();
  set.labels = {0, 2, 0, 2, 0};
  set.record_names = {"N", "R"};
  set.record = {1, 0, 1, 0, 0};
  set.first_sample = {30, 20, 10, 0, 20};
  EXPECT_THAT(in_time_order(set), ElementsAre(3, 1, 4, 2, 0));
  set.record.clear();
  set.first_sample.clear();
  EXPECT_THAT(in_time_order(set), ElementsAre(0, 1, 2, 3, 4));
}

}  // namespace
}  // namespace piae::signal
