#include "classification/line_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bearing/kinematics.hpp"
#include "spectra/floors.hpp"

namespace piae::classification {

namespace {

using signal::Defect;
using spectra::EnvelopeSpectrum;

std::span<const double> bins_between(const EnvelopeSpectrum& spectrum, double low_hz,
                                     double high_hz) {
  const auto last = static_cast<double>(spectrum.power.size() - 1);
  const auto bin = [&](double hz) {
    return static_cast<std::size_t>(std::clamp(std::round(hz / spectrum.bin_hz), 0.0, last));
  };
  return std::span(spectrum.power).subspan(bin(low_hz), bin(high_hz) - bin(low_hz) + 1);
}

/// Returns the rate at which a fault of this type is modulated, in Hz; 0 without modulation: the
/// load on a fault of the outer race, which stands still, is constant.
double modulation_hz(Defect fault_type, const bearing::FaultFrequencies& rates) {
  switch (fault_type) {
    case Defect::inner:
      return rates.shaft_hz;
    case Defect::roller:
      return rates.cage_hz;
    case Defect::outer:
    case Defect::none:
    case Defect::other:
      break;
  }
  return 0;
}

/// Empty if the spectrum cannot separate side bands from the line, whose lobe is two bins wide on
/// each side, as that of a side band.
std::optional<SideBands> side_bands_of(const EnvelopeSpectrum& spectrum, const LineEvidence& found,
                                       double spacing_hz) {
  if (spacing_hz < 4 * spectrum.resolution_hz) return std::nullopt;
  const double hz = found.found_hz;
  const auto around = bins_between(spectrum, hz / 2, 1.5 * hz);
  const double floor = std::max(spectra::median({around.begin(), around.end()}), spectrum.rounding);
  const auto height_db = [&](double place_hz) {
    const auto near = bins_between(spectrum, place_hz - spectrum.resolution_hz,
                                   place_hz + spectrum.resolution_hz);
    return 10 * std::log10(std::max(std::ranges::max(near), spectrum.rounding) / floor);
  };
  // The limit of the line is for a mean over three harmonics.
  return SideBands{.spacing_hz = spacing_hz,
                   .below_db = height_db(hz - spacing_hz),
                   .above_db = height_db(hz + spacing_hz),
                   .limit_db = std::numbers::sqrt3 * found.line.noise_db};
}

}  // namespace

std::array<LineEvidence, 3> line_evidence(const Verdict& verdict, const signal::DatasetInfo& info) {
  std::array<LineEvidence, 3> evidence;
  for (std::size_t i = 0; i < evidence.size(); ++i) evidence.at(i).line = verdict.lines.at(i);
  if (!info.has_bearing) return evidence;
  const Recording& recording = verdict.recording;
  // Verdict::envelope is only the shown part.
  const EnvelopeSpectrum spectrum =
      inspection::envelope_spectrum(signal_for_lines(recording, info.sample_rate_hz),
                                    info.sample_rate_hz, recording.shaft_speed_rpm / 60);
  const bearing::FaultFrequencies rates =
      bearing::fault_frequencies(info.bearing, recording.shaft_speed_rpm);
  for (LineEvidence& each : evidence) {
    if (!each.line.db) continue;
    const spectra::CommonLine found = spectra::common_line(spectrum, each.line.hz);
    each.found_hz = found.hz;
    each.harmonics_db = found.decibels;
    // Around a missing line only the lines of others remain.
    if (!each.has_harmonic(1)) continue;
    each.side_bands = side_bands_of(spectrum, each, modulation_hz(each.line.fault_type, rates));
  }
  return evidence;
}

}  // namespace piae::classification
