#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "signal/dataset_info.hpp"
#include "spectra/lines.hpp"

namespace piae::inspection {

using spectra::EnvelopeSpectrum;

/// Returns the envelope spectrum of a record: mean power over half-overlapping segments of 16 turns
/// of the shaft. Shorter records get shorter segments, so that at least four fit. Empty if a
/// segment would be shorter than ten samples. Each segment lies within one piece and may fill it.
EnvelopeSpectrum envelope_spectrum(std::span<const double> signal, double rate_hz, double shaft_hz,
                                   std::span<const std::size_t> piece_lengths = {});

/// Excess of a defect's line in an envelope spectrum.
struct FaultLine {
  signal::Defect fault_type = signal::Defect::none;
  double hz = 0;  ///< expected, at the record's speed without slip
  /// spectra::common_line().mean_db(). Empty if the record is too short for the line or the rate
  /// too low.
  std::optional<double> db;
  double noise_db = 0;            ///< exceeded by white noise in one record of a thousand
  int harmonics_above_noise = 0;  ///< of three, those above noise_db
  double share_elsewhere = 0;     ///< share of unrelated places with an equal or larger excess
  /// Frequency from 2/3 to 3/2 of `hz` with the strongest three harmonics, divided by `hz`. About 1
  /// (slip) if the line is at its place; 0 if not measured.
  double farthest_factor = 0;
  /// True if the excess exceeds noise_db, at least two of three harmonics do, and more than 95 % of
  /// unrelated places are weaker. Those places hold the lines of shaft, motor and mains.
  bool stands_out = false;
};

/// Lines of outer race, inner race and roller.
using FaultLines = std::array<FaultLine, 3>;

/// Returns "BPFO", "BPFI" or "2BSF".
std::string line_name(signal::Defect fault_type);

/// Returns the measured lines. Without a described bearing, all are at 0 Hz and not measured.
FaultLines fault_lines(const EnvelopeSpectrum& spectrum, const signal::DatasetInfo& info,
                       double shaft_speed_rpm);

/// Returns the line of a defect, which must have one.
const FaultLine& line_of(const FaultLines& lines, signal::Defect fault_type);
/// Returns the line that stands out farthest; null if none does.
const FaultLine* farthest(const FaultLines& lines);

}  // namespace piae::inspection
