#include "classification/recording_page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <regex>

#include "classification/judged.hpp"
#include "classification/line_evidence.hpp"
#include "support/made_recordings.hpp"

namespace piae::classification {
namespace {

using signal::Defect;
using testing::HasSubstr;
using testing::Not;

constexpr double turns_hz = 30;

/// Returns a verdict on ten seconds of impacts of the inner race, which are modulated once a turn.
Verdict verdict_on_inner_race(double modulation, Label label = 1) {
  std::vector<double> samples = impact_recording(12000, 10, impacts_of_classes_hz[1], "inner");
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double turn = turns_hz * static_cast<double>(i) / 12000;
    samples[i] *= 1 + modulation * std::cos(2 * std::numbers::pi * turn);
  }
  diagnosis::KeptClassifier classifier = classifier_of_toys();
  Verdict verdict = judge({.name = "struck.csv",
                           .given_speed_rpm = 1800,
                           .shaft_speed_rpm = 1800,
                           .true_class = "",
                           .signal = samples},
                          classifier, judged_length);
  verdict.label = label;
  verdict.unknown = false;
  return verdict;
}

std::string page_on(const Verdict& verdict, const signal::DatasetInfo& info = three_classes()) {
  return recording_page(verdict, {.info = info, .is_calibrated = true, .words = "by <toys>\n"});
}

const LineEvidence& evidence_of_line(const std::array<LineEvidence, 3>& all, Defect fault_type) {
  return *std::ranges::find_if(
      all, [&](const LineEvidence& each) { return each.line.fault_type == fault_type; });
}

TEST(LineEvidence, ExplainsTheHeightOfTheLine) {
  const Verdict verdict = verdict_on_inner_race(0.8);
  for (const LineEvidence& each : line_evidence(verdict, three_classes())) {
    ASSERT_TRUE(each.line.db);
    const double sum = std::accumulate(each.harmonics_db.begin(), each.harmonics_db.end(), 0.0);
    EXPECT_NEAR(sum / 3, *each.line.db, 1e-9);
    EXPECT_NEAR(each.found_hz / each.line.hz, 1, 0.021);
  }
}

TEST(LineEvidence, FindsSideBandsOfAModulatedLineOnly) {
  const auto bands = [](double modulation) {
    const auto all = line_evidence(verdict_on_inner_race(modulation), three_classes());
    return evidence_of_line(all, Defect::inner).side_bands.value();
  };
  EXPECT_DOUBLE_EQ(bands(0.8).spacing_hz, turns_hz);
  EXPECT_EQ(bands(0.8).present(), 2);
  EXPECT_EQ(bands(0).present(), 0);
}

// The load on the outer race does not turn.
TEST(LineEvidence, HasNoSideBandsOfOtherLines) {
  const auto all = line_evidence(verdict_on_inner_race(0), three_classes());
  EXPECT_FALSE(evidence_of_line(all, Defect::outer).side_bands);
}

TEST(RecordingPage, ReportsVerdictAndEvidence) {
  const Verdict verdict = verdict_on_inner_race(0.8);
  const std::string page = page_on(verdict);
  EXPECT_THAT(page, HasSubstr("<h1>struck.csv</h1>"));
  EXPECT_THAT(page, HasSubstr("Verdict: Fault of the inner race (class IR)"));
  EXPECT_THAT(page, HasSubstr("(calibrated), a mean over 117 windows"));
  EXPECT_THAT(page, HasSubstr("spectrum supports the verdict"));
  EXPECT_THAT(page, HasSubstr("BPFI (162.5 Hz, 5.42 orders)"));  // 4.5 (1 + 7.94 / 39) 30 Hz
  EXPECT_THAT(page, HasSubstr("Harmonic 2 is present"));
  EXPECT_THAT(page, HasSubstr("Side bands are present at the shaft speed (\u00b130.00 Hz"));
  EXPECT_THAT(page, HasSubstr("10.00 s, 300 turns"));
  EXPECT_THAT(page, HasSubstr("Plan an inspection"));
  EXPECT_THAT(page, HasSubstr("Classified by &lt;toys&gt;"));
  EXPECT_LT(page.size(), 400'000U);
}

TEST(RecordingPage, WarnsOfAVerdictThatTheSpectrumContradicts) {
  const std::string outer = page_on(verdict_on_inner_race(0, 2));
  EXPECT_THAT(outer, HasSubstr("spectrum does not support the verdict"));
  EXPECT_THAT(outer, HasSubstr("The line of the inner race stands out: BPFI (162.5 Hz"));
  EXPECT_THAT(page_on(verdict_on_inner_race(0, 0)), HasSubstr("This contradicts the verdict."));
}

TEST(RecordingPage, ShowsUnknownRecordings) {
  const std::string page = page_on(judged("a", {-1, -1, 1}));
  EXPECT_THAT(page, HasSubstr("Verdict: Unknown"));
  EXPECT_THAT(page, HasSubstr("67 % of the windows differ from all trained classes."));
}

TEST(RecordingPage, MakesDoWithoutABearing) {
  signal::DatasetInfo info = three_classes();
  info.has_bearing = false;
  Verdict verdict = judged("a", {1, 1, 0});
  verdict.lines = {};
  const std::string page = page_on(verdict, info);
  EXPECT_THAT(page, HasSubstr("The bearing is not described"));
  EXPECT_THAT(page, HasSubstr("\"lines\":[]"));
  EXPECT_THAT(page, Not(HasSubstr("<table")));
  EXPECT_THAT(page, Not(HasSubstr("BPFI")));
  EXPECT_THAT(page, Not(HasSubstr("cage speed")));
}

TEST(RecordingPage, MakesDoWithAShortRecording) {
  const std::string page = page_on(judged("a", {1}));
  EXPECT_THAT(page, HasSubstr("too short to measure BPFI"));
  EXPECT_THAT(page, HasSubstr("\"spectrum\":{"));
}

TEST(RecordingPage, EscapesNames) {
  Verdict verdict = judged("</title><b>&\"x\".csv", {1}, "<i>");
  const std::string page = page_on(verdict);
  EXPECT_THAT(page, HasSubstr("<h1>&lt;/title&gt;&lt;b&gt;&amp;&quot;x&quot;.csv</h1>"));
  EXPECT_THAT(page, HasSubstr("<dd>&lt;i&gt;</dd>"));
  EXPECT_THAT(page, Not(HasSubstr("<b>")));
}

TEST(RecordingPage, RequestsNothing) {
  const std::string page = page_on(judged("a", {1, 0}));
  EXPECT_THAT(page, Not(HasSubstr("http:")));
  EXPECT_THAT(page, Not(HasSubstr("https:")));
  EXPECT_THAT(page, Not(HasSubstr("@import")));
  EXPECT_THAT(page, Not(HasSubstr("url(")));
  const std::regex address("(src|href)=\"(?!data:,\"|#content\")");
  EXPECT_FALSE(std::regex_search(page, address));
}

TEST(RecordingPage, IsTheSameEachTime) {
  EXPECT_EQ(page_on(judged("a", {1, 0})), page_on(judged("a", {1, 0})));
}

}  // namespace
}  // namespace piae::classification
