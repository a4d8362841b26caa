#include "diagnosis/line_rules.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/stored.hpp"
#include "support/errors.hpp"
#include "support/impact_windows.hpp"

namespace piae::diagnosis {
namespace {

/// Returns classes in another order than the fault types.
signal::DatasetInfo four_types() {
  signal::DatasetInfo info = three_classes();
  info.classes = {{"outer", signal::Defect::outer, 0.2},
                  {"Normal", signal::Defect::none, 0},
                  {"ball", signal::Defect::roller, 0.2},
                  {"inner", signal::Defect::inner, 0.2}};
  return info;
}

std::string named(const signal::DatasetInfo& info, const Findings& findings, Rule rule) {
  const std::vector<float> all = evidence(info, findings, rule);
  return info.classes[static_cast<std::size_t>(std::ranges::max_element(all) - all.begin())].name;
}

TEST(Evidence, IsTheExcessOfEachFaultTypeAndFiveForHealthy) {
  const Findings findings{.excesses = {1, 2, 3}, .novelty = 0.5};  // inner, ball, outer
  for (const Rule rule : {Rule::envelope, Rule::exclusion}) {
    EXPECT_EQ(evidence(four_types(), findings, rule), (std::vector<float>{3, 5, 2, 1}));
    EXPECT_EQ(evidence(three_classes(), findings, rule), (std::vector<float>{5, 1, 3}));
  }
}

TEST(Evidence, LineAboveFivePredictsItsTypeWhateverTheNovelty) {
  for (const Rule rule : {Rule::envelope, Rule::exclusion}) {
    for (const double novelty : {0.1, 9.0}) {
      EXPECT_EQ(named(four_types(), {{5.1, 1, 4}, novelty}, rule), "inner");
      EXPECT_EQ(named(four_types(), {{5.1, 6, 4}, novelty}, rule), "ball");
      EXPECT_EQ(named(four_types(), {{5.1, 6, 40}, novelty}, rule), "outer");
    }
    EXPECT_EQ(named(four_types(), {{4.9, 4.9, 4.9}, 0.99}, rule), "Normal");
  }
}

TEST(Evidence, NoveltyWithoutALineIsABallForExclusionOnly) {
  const Findings findings{.excesses = {1, 2, 4}, .novelty = 1.5};
  EXPECT_EQ(named(four_types(), findings, Rule::envelope), "Normal");
  EXPECT_EQ(evidence(four_types(), findings, Rule::exclusion), (std::vector<float>{4, 5, 7.5, 1}));
  // Without a class of ball defects, the highest line gives the fault type.
  EXPECT_EQ(evidence(three_classes(), findings, Rule::exclusion), (std::vector<float>{5, 1, 7.5}));
}

// A line without a class does not count.
TEST(Evidence, IgnoresTypesWithoutAClass) {
  EXPECT_EQ(named(three_classes(), {{1, 50, 2}, 0.5}, Rule::envelope), "Normal");
}

Outputs judged_by_rule(const signal::WindowSet& normal, const signal::WindowSet& test, Rule rule) {
  return TrainedRule(normal, rule, 0).outputs(test, "--test");
}

std::vector<Label> named_by_rule(const signal::WindowSet& normal, const signal::WindowSet& test,
                                 Rule rule) {
  return most_likely(judged_by_rule(normal, test, rule).scores, 3);
}

class Rules : public testing::Test {
 protected:
  Rules() {
    Stream stream("rules");
    add_impact_windows(normal_, 0, 40, stream);
    for (const Label label : {0, 1, 2}) add_impact_windows(test_, label, 10, stream);
  }
  signal::WindowSet normal_ = no_impact_windows();
  signal::WindowSet test_ = no_impact_windows();
};

TEST_F(Rules, PredictTheDefectiveElement) {
  for (const Rule rule : {Rule::envelope, Rule::exclusion}) {
    EXPECT_EQ(named_by_rule(normal_, test_, rule), test_.labels);
  }
}

TEST_F(Rules, ScoreByTheSoftmaxOfTheEvidence) {
  const Outputs answer = judged_by_rule(normal_, test_, Rule::envelope);
  const std::vector<Label> named = most_likely(answer.scores, 3);
  ASSERT_EQ(answer.scores.size(), 90U);
  for (std::size_t i = 0; i < 30; ++i) {
    const auto row = std::span(answer.scores).subspan(3 * i, 3);
    EXPECT_NEAR(row[0] + row[1] + row[2], 1, 1e-6);
    EXPECT_EQ(std::ranges::max_element(row) - row.begin(), named[i]);
  }
  EXPECT_LT(answer.scores[0], 1);               // healthy, by some deviations
  EXPECT_GT(answer.scores[3 * 10 + 1], 0.999);  // inner, by many
}

TEST_F(Rules, IgnoreTheLevelOfAWindow) {
  for (float& sample : test_.samples) sample = 20 * sample + 3;
  EXPECT_EQ(named_by_rule(normal_, test_, Rule::exclusion), test_.labels);
}

/// Reduces the noise above a quarter of the sample rate: x[t] = n[t] + 0.5 n[t - 1].
void make_duller(signal::WindowSet& set) {
  for (std::size_t i = set.samples.size() - 1; i > 0; --i) set.samples[i] += set.samples[i - 1] / 2;
}

// The evidence for a fault type is the excess of its line in prewhitened spectra.
TEST_F(Rules, ComparePrewhitenedSpectra) {
  const double prewhitening = 0.5;
  symptoms::Baselines baselines(normal_, symptoms::measure(normal_, "", prewhitening));
  const auto tested = symptoms::measure(test_, "", prewhitening);
  TrainedRule rule(normal_, Rule::envelope, prewhitening);
  const Outputs judged = rule.outputs(test_, "--test");
  for (std::size_t i = 0; i < test_.size(); ++i) {
    const auto excesses = baselines.at(test_.speed_rpm(i)).excesses(tested[i]);
    EXPECT_FLOAT_EQ(judged.logits[3 * i + 1], static_cast<float>(excesses[0]));  // inner
    EXPECT_FLOAT_EQ(judged.logits[3 * i + 2], static_cast<float>(excesses[2]));  // outer
  }
  EXPECT_NE(judged.logits, judged_by_rule(normal_, test_, Rule::envelope).logits);
}

TEST_F(Rules, StorePrewhiteningUnlessItIsZero) {
  for (const double prewhitening : {0.0, 0.5}) {
    TrainedRule before(normal_, Rule::exclusion, prewhitening);
    artefact::Writer writer("classifier");
    before.write(writer);
    const Folder folder;
    const artefact::Reader reader = stored(writer, folder);
    EXPECT_EQ(reader.has_attribute(learned, symptoms::prewhitening_name), prewhitening > 0);
    TrainedRule after(reader, normal_.info, Rule::exclusion);
    EXPECT_EQ(after.outputs(test_, "--test").logits, before.outputs(test_, "--test").logits);
  }
}

TEST_F(Rules, ExclusionDetectsAChangeWithoutALine) {
  Stream stream("changed");
  signal::WindowSet changed = no_impact_windows();
  add_impact_windows(changed, 0, 10, stream);
  make_duller(changed);
  changed.info.classes[1].defect = signal::Defect::roller;
  EXPECT_EQ(named_by_rule(normal_, changed, Rule::envelope), std::vector<Label>(10, 0));
  EXPECT_EQ(named_by_rule(normal_, changed, Rule::exclusion), std::vector<Label>(10, 1));
}

TEST_F(Rules, CompareWindowsOfOneSpeed) {
  // At another speed healthy windows are duller: what is new at one speed is not new at the other.
  Stream stream("speeds");
  signal::WindowSet dull = no_impact_windows();
  add_impact_windows(dull, 0, 50, stream);
  make_duller(dull);
  const auto with_speed = [](signal::WindowSet& set, double speed_rpm) {
    set.condition.assign(set.size(), signal::every_condition);
    set.shaft_speed_rpm.assign(set.size(), speed_rpm);
  };
  with_speed(normal_, 1800);
  with_speed(dull, 1200);
  for (std::size_t i = 0; i < 40; ++i) normal_.append(dull, i);
  signal::WindowSet tested = no_impact_windows();
  for (std::size_t i = 40; i < 50; ++i) tested.append(dull, i);
  EXPECT_EQ(named_by_rule(normal_, tested, Rule::exclusion), std::vector<Label>(10, 0));
  tested.shaft_speed_rpm.assign(10, 1800);
  const auto at_the_other = named_by_rule(normal_, tested, Rule::exclusion);
  EXPECT_EQ(std::ranges::count(at_the_other, 0), 0);
}

TEST_F(Rules, NeedFaultsOfTheBearing) {
  normal_.info.classes[2].defect = signal::Defect::other;
  EXPECT_ERROR(named_by_rule(normal_, test_, Rule::exclusion), Exit::bad_input,
               "class OR of data set toy has defect 'other', which does not have a fault line");
}

TEST_F(Rules, NeedOneClassPerFaultType) {
  normal_.info.classes[2].defect = signal::Defect::inner;
  EXPECT_ERROR(named_by_rule(normal_, test_, Rule::envelope), Exit::bad_input,
               "data set toy has several classes of one type, IR and OR");
}

}  // namespace
}  // namespace piae::diagnosis
