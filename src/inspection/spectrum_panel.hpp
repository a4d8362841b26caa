#pragma once

#include <string>

#include "inspection/drawing.hpp"
#include "inspection/fault_lines.hpp"
#include "inspection/svg.hpp"

namespace piae::inspection {

/// Cuts a spectrum off behind what a drawing shows of it.
void keep_shown_part(EnvelopeSpectrum& spectrum, const FaultLines& lines, double shaft_hz);

/// An envelope spectrum in dB over its own median, with the lines of the three defects and their
/// second and third harmonics marked and named; those of `own` are thick. The names stand above the
/// panel, in three rows of 11 pixels. Draws nothing of an empty spectrum.
void draw_envelope_spectrum(Svg& svg, const EnvelopeSpectrum& spectrum, const FaultLines& lines,
                            signal::Defect own, const Panel& panel);

/// What the lines of that drawing are, from a point on; `thick` says whose are thick.
void draw_line_legend(Svg& svg, const FaultLines& lines, Point at, const std::string& thick);

}  // namespace piae::inspection
