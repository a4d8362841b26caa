#include "inspection/picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "inspection/found.hpp"
#include "inspection/svg.hpp"
#include "support/made_recordings.hpp"
#include "support/shown.hpp"

namespace piae::inspection {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Returns a Found with the signals for the picture.
Found drawn() {
  Found found;
  for (RecordCheck& record : found.check.records) {
    const double impacts_hz = record.source.label == 0 ? 0 : 107;
    const auto samples = impact_recording(12000, 2, impacts_hz, record.source.name);
    record.beginning.assign(samples.begin(), samples.begin() + 2400);
    record.envelope = envelope_spectrum(samples, 12000, 1797 / 60.0);
    record.envelope.power.resize(600);
  }
  return found;
}

std::string picture_of(const Found& found) {
  return inspection::picture_of(found.description.info, found.check);
}

TEST(Svg, EscapesTextAndWritesWhatWasDrawn) {
  Svg svg(200, 100, "a < b");
  svg.text({10, 20.04}, "R & D", Anchor::end, 12, true);
  svg.line({0, 1}, {2.25, 3}, {"#0072B2", 2, "7 3"});
  const std::string text = svg.str();
  EXPECT_THAT(text, HasSubstr("<title>a &lt; b</title>"));
  EXPECT_THAT(text, HasSubstr("<text x=\"10.0\" y=\"20.0\" font-size=\"12\" text-anchor=\"end\" "
                              "font-weight=\"bold\" fill=\"#222222\">R &amp; D</text>"));
  EXPECT_THAT(text, HasSubstr("<polyline points=\"0.0,1.0 2.2,3.0 \" stroke=\"#0072B2\" "
                              "stroke-width=\"2\" stroke-dasharray=\"7 3\" fill=\"none\"/>"));
  EXPECT_TRUE(text.ends_with("</svg>\n"));
}

TEST(Picture, HasARowForEachRecordWithItsLinesMarkedAndNamed) {
  const Found found = drawn();
  const std::string picture = picture_of(found);
  EXPECT_THAT(picture, HasSubstr(">ok (ok.csv), healthy<"));
  EXPECT_THAT(picture, HasSubstr(">outer (outer.csv), BPFO 107.3 Hz: 20.0 dB<"));
  for (const std::string name : {">BPFO<", ">BPFI<", ">2BSF<"}) {
    EXPECT_EQ(count_of(picture, name), 5U) << name;  // the legend's and one per row
  }
  // 600 bins of 0.47 Hz reach the second harmonics of BPFO and 2BSF. Thick: the record's own.
  EXPECT_EQ(count_of(picture, "stroke-width=\"2.4\" stroke-dasharray=\"7 3\""), 1U);
  EXPECT_EQ(count_of(picture, "stroke-width=\"2.4\" stroke-dasharray=\"2 2\""), 1U);
  EXPECT_EQ(count_of(picture, ">2<"), 4U);
}

TEST(Picture, MarksNothingBeyondItsPaper) {
  Found found = drawn();
  for (RecordCheck& record : found.check.records) record.envelope.power.resize(200);
  const std::string picture = picture_of(found);
  expect_on_paper(picture, 1080, 400);  // two spectra of 200 bins alone
}

TEST(Picture, LeavesOutUnreadableRecords) {
  Found found = drawn();
  found.check.records[1].beginning.clear();
  EXPECT_THAT(picture_of(found), Not(HasSubstr("outer.csv")));
  for (RecordCheck& record : found.check.records) record.beginning.clear();
  EXPECT_TRUE(picture_of(found).ends_with("</svg>\n"));
}

TEST(Picture, IsTheSameBytesEachTime) { EXPECT_EQ(picture_of(drawn()), picture_of(drawn())); }

}  // namespace
}  // namespace piae::inspection
