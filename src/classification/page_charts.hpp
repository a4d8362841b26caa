#pragma once

#include <span>
#include <string>
#include <vector>

#include "classification/verdict.hpp"

namespace piae::classification {

/// Mean amplitude spectrum of a recording.
struct AmplitudeSpectrum {
  std::vector<double> db;  ///< by bin: RMS of a tone there, in dB re one unit of the recording
  double bin_hz = 0;
  std::size_t segments = 0;
};

/// Returns the mean power over segments that overlap by half, tapered by Hann's window, of 32 turns
/// of the shaft: two per line of the envelope spectrum. Segments have 32768 samples at most, and
/// four fit into a short recording. Empty for fewer than ten samples a segment.
AmplitudeSpectrum amplitude_spectrum(std::span<const double> signal, double rate_hz,
                                     double shaft_hz);

/// A chart as a drawing (SVG, an element of HTML), and its numbers for the script of the page
/// (JSON, an object).
struct Chart {
  std::string drawing;
  std::string numbers;
};

/// Return the charts of a recording: the lowest and highest sample on each pixel, over time; the
/// amplitude spectrum; and the envelope spectrum of picture_of(). All have a second axis in turns
/// or orders of the shaft. `own` is the predicted defect, whose lines are thick.
Chart waveform_chart(const Verdict& verdict, const signal::DatasetInfo& info);
Chart amplitude_chart(const Verdict& verdict, const signal::DatasetInfo& info, signal::Defect own);
Chart envelope_chart(const Verdict& verdict, signal::Defect own);

}  // namespace piae::classification
