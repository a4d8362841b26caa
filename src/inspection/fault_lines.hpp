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

/// Returns the envelope spectrum of a record: mean power over segments of 16 turns of the shaft
/// (less where the record is short, so that there are at least four), which overlap by half. Empty
/// where the record is shorter than ten samples a segment. Of a record in pieces, whose lengths are
/// given, each segment lies within one, and may be a whole one.
EnvelopeSpectrum envelope_spectrum(std::span<const double> signal, double rate_hz, double shaft_hz,
                                   std::span<const std::size_t> piece_lengths = {});

/// How far a defect's line stands out of an envelope spectrum.
struct FaultLine {
  signal::Defect kind = signal::Defect::none;
  double hz = 0;  ///< where it should be: at the record's speed, without slip
  /// spectra::common_line().mean_db(). None where the record is too short for the line, or the rate
  /// too low.
  std::optional<double> db;
  double noise_db = 0;            ///< what white noise alone exceeds in one record of a thousand
  int harmonics_above_noise = 0;  ///< of the three, those above noise_db
  double share_elsewhere = 0;  ///< of the places where no fault has a line: as far out as this one
  /// Frequency from 2/3 to 3/2 of `hz` at which the three harmonics stand out farthest, over `hz`:
  /// 1, but for slip, if the line is at its place. 0 if nothing was measured.
  double farthest_factor = 0;
  /// Farther than noise alone, with two of the three harmonics at least, and farther than 95 % of
  /// the other places of this spectrum, which hold the lines of shaft, motor and mains.
  bool stands_out = false;
};

/// Outer, inner, roller.
using FaultLines = std::array<FaultLine, 3>;

/// "BPFO", "BPFI", "2BSF".
std::string line_name(signal::Defect kind);

/// All at 0 Hz, and none measured, where the bearing is not described.
FaultLines fault_lines(const EnvelopeSpectrum& spectrum, const signal::DatasetInfo& info,
                       double shaft_speed_rpm);

/// The line of a defect, of which there must be one.
const FaultLine& line_of(const FaultLines& lines, signal::Defect kind);
/// Of the lines that stand out the one that does so farthest; null where none does.
const FaultLine* farthest(const FaultLines& lines);

}  // namespace piae::inspection
