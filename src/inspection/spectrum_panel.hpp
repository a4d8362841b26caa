#pragma once

#include <string>
#include <vector>

#include "inspection/drawing.hpp"
#include "inspection/fault_lines.hpp"
#include "inspection/svg.hpp"

namespace piae::inspection {

/// Removes the part of a spectrum above the drawing's range.
void keep_shown_part(EnvelopeSpectrum& spectrum, const FaultLines& lines, double shaft_hz);

/// Draws an envelope spectrum in dB over its own median. Marks and names the lines of the three
/// defects and their second and third harmonics; the lines of `own` are thick. The names stand
/// above the panel, in three rows of 11 pixels. Draws nothing for an empty spectrum. Returns the
/// axis of the decibels.
Axis draw_envelope_spectrum(Svg& svg, const EnvelopeSpectrum& spectrum, const FaultLines& lines,
                            signal::Defect own, const Panel& panel);

/// Returns the power of each bin in dB over the median of all, at least -10: what is drawn.
std::vector<double> drawn_decibels(const EnvelopeSpectrum& spectrum);

/// Draws the lines of the three defects and their harmonics up to `harmonics` on a frequency axis,
/// as draw_envelope_spectrum() does.
void draw_fault_lines(Svg& svg, const FaultLines& lines, signal::Defect own, int harmonics,
                      const Axis& x, const Panel& panel);

/// Draws the legend of the lines, starting at a point; `thick` describes the thick lines.
void draw_line_legend(Svg& svg, const FaultLines& lines, Point at, const std::string& thick);

}  // namespace piae::inspection
