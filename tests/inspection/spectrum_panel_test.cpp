#include "inspection/spectrum_panel.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/made_recordings.hpp"
#include "support/three_classes.hpp"

namespace piae::inspection {
namespace {

using testing::HasSubstr;
using testing::Not;

EnvelopeSpectrum impact_spectrum() {
  return envelope_spectrum(impact_recording(12000, 2, 107.5, "panel"), 12000, 30);
}

std::string panel_of(const EnvelopeSpectrum& spectrum, signal::Defect own) {
  Svg svg(400, 200, "panel");
  draw_envelope_spectrum(svg, spectrum, fault_lines(spectrum, three_classes(), 1800), own,
                         {.left = 50, .top = 50, .width = 300, .height = 100});
  return svg.str();
}

// BPFO, BPFI and 2BSF at 1800 rpm are 107.5, 162.5 and 141.2 Hz.
TEST(SpectrumPanel, EndsAboveTheThirdHarmonicOfTheHighestLine) {
  EnvelopeSpectrum spectrum = impact_spectrum();
  const FaultLines lines = fault_lines(spectrum, three_classes(), 1800);
  keep_shown_part(spectrum, lines, 30);
  EXPECT_NEAR(static_cast<double>(spectrum.power.size()) * spectrum.bin_hz, 3.5 * 162.5,
              1 + spectrum.bin_hz);
  const std::size_t size = spectrum.power.size();
  keep_shown_part(spectrum, lines, 30);
  EXPECT_EQ(spectrum.power.size(), size);
}

TEST(SpectrumPanel, MarksTheLinesAndHighlightsThoseOfOneDefect) {
  EnvelopeSpectrum spectrum = impact_spectrum();
  keep_shown_part(spectrum, fault_lines(spectrum, three_classes(), 1800), 30);
  const std::string outer = panel_of(spectrum, signal::Defect::outer);
  EXPECT_THAT(outer, HasSubstr("font-weight=\"bold\" fill=\"#222222\">BPFO<"));
  EXPECT_THAT(outer, HasSubstr("stroke=\"#0072B2\" stroke-width=\"2.4\""));
  EXPECT_THAT(outer, HasSubstr(">2BSF<"));
  EXPECT_THAT(outer, HasSubstr(">3<"));
  EXPECT_THAT(panel_of(spectrum, signal::Defect::none), Not(HasSubstr("stroke-width=\"2.4\"")));
}

TEST(SpectrumPanel, IsEmptyForAnEmptySpectrum) {
  EXPECT_EQ(panel_of({}, signal::Defect::outer), Svg(400, 200, "panel").str());
}

TEST(LineLegend, NamesTheThreeLinesAndTheThickOnes) {
  Svg svg(400, 200, "legend");
  draw_line_legend(svg, fault_lines({}, three_classes(), 1800), {10, 10}, "the named fault");
  const std::string legend = svg.str();
  for (const std::string name : {">BPFO<", ">BPFI<", ">2BSF<"}) {
    EXPECT_THAT(legend, HasSubstr(name));
  }
  EXPECT_THAT(legend, HasSubstr(">2, 3: harmonics; thick: the named fault<"));
}

}  // namespace
}  // namespace piae::inspection
