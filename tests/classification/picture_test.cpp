#include "classification/picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "classification/judged.hpp"
#include "support/made_recordings.hpp"
#include "support/shown.hpp"

namespace piae::classification {
namespace {

using testing::HasSubstr;

std::string drawn(const std::vector<Verdict>& verdicts) {
  return picture_of(verdicts, three_classes(), judged_length);
}

/// Counts rectangles of a colour; each window has one.
std::size_t bars(const std::string& picture, const std::string& colour) {
  return count_of(picture, "fill=\"" + colour + "\"");
}

TEST(ClassificationPicture, HasATimeLineWithABarForEachWindow) {
  const std::string picture = drawn({judged("a.csv", {1, 0, 1, -1}, "OR")});
  EXPECT_THAT(picture, HasSubstr(">a.csv (described as OR): IR, 57 % sure<"));
  for (const std::string name : {"Normal", "IR", "OR", "unknown"}) {
    EXPECT_GE(count_of(picture, ">" + name + "<"), 1U) << name;
  }
  EXPECT_EQ(bars(picture, "#009E73"), 1U);  // healthy
  // 0.8: in the third quarter from half certain to certain
  EXPECT_EQ(bars(picture, "#e0702f"), 2U);
  EXPECT_EQ(bars(picture, "#999999"), 1U);  // unknown
  EXPECT_TRUE(picture.ends_with("</svg>\n"));
}

TEST(ClassificationPicture, ShowsUnknownRecordings) {
  const std::string picture = drawn({judged("a.csv", {-1, -1, 1})});
  EXPECT_THAT(picture,
              HasSubstr(">a.csv: unknown, 67 % of its windows differ from all trained classes<"));
}

// The legend and each row name the lines; those of the predicted fault are thick.
TEST(ClassificationPicture, ShowsTheEnvelopeSpectrumWithTheLinesOfThePredictedFault) {
  Recording recording{.name = "struck",
                      .shaft_speed_rpm = 1800,
                      .true_class = "",
                      .signal = impact_recording(12000, 2, impacts_of_classes_hz[1], "struck")};
  diagnosis::KeptClassifier classifier = classifier_of_toys();
  Verdict verdict = judge(recording, classifier, judged_length);
  verdict.label = 1;
  verdict.unknown = false;
  const std::string picture = drawn({verdict});
  EXPECT_EQ(count_of(picture, ">BPFI<"), 2U);
  EXPECT_EQ(count_of(picture, "stroke-width=\"2.4\" stroke-dasharray=\"7 3\""), 3U);
  verdict.unknown = true;
  EXPECT_EQ(count_of(drawn({verdict}), "stroke-width=\"2.4\""), 0U);
}

TEST(ClassificationPicture, DrawsNothingOutsideThePage) {
  const std::string picture = drawn({judged("a", std::vector<int>(40, 1)), judged("b", {0})});
  expect_on_paper(picture, 1080, 40);
}

TEST(ClassificationPicture, EscapesNames) {
  EXPECT_THAT(drawn({judged("a<b&c.csv", {1})}), HasSubstr(">a&lt;b&amp;c.csv: IR"));
}

}  // namespace
}  // namespace piae::classification
