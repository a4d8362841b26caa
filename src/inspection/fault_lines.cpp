#include "inspection/fault_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "bearing/impact_frequency.hpp"
#include "scoring/distributions.hpp"
#include "spectra/lengths.hpp"

namespace piae::inspection {

namespace {

using signal::Defect;
using spectra::CommonLine;
using spectra::EnvelopeSpectrum;
using spectra::line_harmonics;
using spectra::line_tolerance;
using spectra::Windows;

constexpr double turns_in_a_segment = 16;
constexpr double largest_part = 0.4;  // largest share of the record in a segment, so that four fit
constexpr std::size_t most_segments = 200;  // longer records are sampled at intervals
constexpr std::size_t shortest_segment = 10;
constexpr double chance_of_noise = 1e-3;  // that white noise alone counts as a line
constexpr int fewest_harmonics = 2;
constexpr double largest_share_elsewhere = 0.05;
constexpr double largest_factor = 1.5;        // at a factor of 2 a line meets its own harmonics
constexpr double step_between_places = 0.02;  // in the logarithm of the frequency

using Pieces = std::vector<std::span<const double>>;

/// Adds half-overlapping segments of a piece. Spreads at most `most` of them over a long piece.
void add_segments(std::span<const double> piece, std::size_t length, std::size_t most,
                  Pieces& segments) {
  const std::size_t half = std::max<std::size_t>(1, length / 2);
  const std::size_t rest = piece.size() - length;
  const std::size_t count = std::min(most, rest / half + 1);
  for (std::size_t i = 0; i < count; ++i) {
    segments.push_back(piece.subspan(i * std::max(half, rest / most), length));
  }
}

/// Returns segments of all long enough pieces, or of a selection if there are too many. A segment
/// does not cross from one piece into the next.
Windows segments_of(Pieces pieces, std::size_t length) {
  std::erase_if(pieces, [&](const auto& piece) { return piece.size() < length; });
  const std::size_t step = std::max<std::size_t>(1, pieces.size() / most_segments);
  const std::size_t most = std::max<std::size_t>(1, most_segments / pieces.size());
  Pieces found;
  for (std::size_t i = 0; i < pieces.size(); i += step) {
    add_segments(pieces[i], length, most, found);
  }
  Windows segments(found.size(), length);
  for (std::size_t i = 0; i < found.size(); ++i) {
    segments.row(static_cast<Eigen::Index>(i)) =
        Eigen::Map<const Eigen::RowVectorXd>(found[i].data(), segments.cols());
  }
  return segments;
}

/// Returns the most samples of a segment: four segments must fit into one piece, or one into each
/// of four equal pieces.
double longest_segment(const Pieces& pieces) {
  const std::size_t longest =
      std::ranges::max(pieces, {}, [](const auto& piece) { return piece.size(); }).size();
  const auto as_long =
      std::ranges::count_if(pieces, [&](const auto& piece) { return piece.size() == longest; });
  return (as_long >= 4 ? 1 : largest_part) * static_cast<double>(longest);
}

/// Returns the number of independent averages. Half-overlapping Hann windows correlate by 1/6,
/// their powers by the square of that.
double independent_averages(double segments) {
  return segments / (1 + 2.0 / 36 * (segments - 1) / segments);
}

/// Returns the excess of white noise's line over its floor, in dB, that occurs with the given
/// chance. Power averaged over `a` segments has a gamma distribution of shape `a`. Its logarithm
/// has the variance trigamma(a), here by its asymptotic series, and its mean is close to the
/// logarithm of its median. The mean over three harmonics counts as normal, which errs to the high
/// side, because the logarithm's upper tail falls faster. The search takes the best place within
/// the tolerance. Independent places: the bins that the third harmonic passes, without padding.
double noise_line_db(double averages, double places) {
  const double a = averages;
  const double variance = 1 / a + 1 / (2 * a * a) + 1 / (6 * a * a * a);
  const double deviation_db = 10 / std::numbers::ln10 * std::sqrt(variance / line_harmonics);
  constexpr double as_good_as_normal = 1e9;  // degrees of freedom
  return deviation_db * scoring::student_t_exceeded_with(chance_of_noise / std::max(1.0, places),
                                                         as_good_as_normal);
}

/// True if lines at one frequency share harmonics with lines at the other.
bool are_related(double hz, double other_hz) {
  constexpr std::array ratios{1.0 / 3, 1.0 / 2, 2.0 / 3, 1.0, 3.0 / 2, 2.0, 3.0};
  return std::ranges::any_of(ratios, [&](double ratio) {
    return std::abs(std::log(hz / (ratio * other_hz))) <
           2 * line_tolerance + step_between_places / 4;
  });
}

/// Returns the excess in dB of lines at places unrelated to faults of this bearing, from half the
/// lowest to twice the highest fault line.
std::vector<double> elsewhere_db(const EnvelopeSpectrum& spectrum, const FaultLines& lines) {
  const auto [low, high] = std::ranges::minmax(lines, {}, &FaultLine::hz);
  std::vector<double> decibels;
  const double lowest_hz = low.hz / 2;
  const auto last = std::lround(std::log(2 * high.hz / lowest_hz) / step_between_places);
  for (long i = 0; i <= last; ++i) {
    const double hz = lowest_hz * std::exp(static_cast<double>(i) * step_between_places);
    const bool related =
        std::ranges::any_of(lines, [&](const FaultLine& line) { return are_related(hz, line.hz); });
    if (related || !spectra::can_measure_common_line(spectrum, hz)) continue;
    decibels.push_back(spectra::common_line(spectrum, hz).mean_db());
  }
  return decibels;
}

/// Returns FaultLine::farthest_factor. The spacing of the places equals the width of each search.
double farthest_factor(const EnvelopeSpectrum& spectrum, double line_hz) {
  CommonLine farthest;
  farthest.decibels.fill(-std::numeric_limits<double>::infinity());
  const auto last = std::lround(std::log(largest_factor) / (2 * line_tolerance));
  for (long i = -last; i <= last; ++i) {
    const double hz = line_hz * std::exp(2 * line_tolerance * static_cast<double>(i));
    if (!spectra::can_measure_common_line(spectrum, hz)) continue;
    const CommonLine line = spectra::common_line(spectrum, hz);
    if (line.mean_db() > farthest.mean_db()) farthest = line;
  }
  return farthest.hz / line_hz;
}

}  // namespace

EnvelopeSpectrum envelope_spectrum(std::span<const double> signal, double rate_hz, double shaft_hz,
                                   std::span<const std::size_t> piece_lengths) {
  Pieces pieces;
  for (const std::size_t length : piece_lengths) {
    pieces.push_back(signal.first(length));
    signal = signal.subspan(length);
  }
  if (pieces.empty()) pieces.push_back(signal);
  const double samples = std::min(turns_in_a_segment * rate_hz / shaft_hz, longest_segment(pieces));
  EnvelopeSpectrum spectrum;
  if (samples < shortest_segment) return spectrum;
  const std::size_t length = spectra::fast_length(static_cast<std::size_t>(samples));
  const Windows segments = segments_of(std::move(pieces), length);
  spectrum = spectra::envelope_spectrum(segments, rate_hz);
  spectrum.averages = independent_averages(spectrum.averages);
  return spectrum;
}

std::string line_name(Defect fault_type) {
  switch (fault_type) {
    case Defect::outer:
      return "BPFO";
    case Defect::inner:
      return "BPFI";
    case Defect::roller:
      return "2BSF";
    case Defect::none:
    case Defect::other:
      break;
  }
  throw std::logic_error("only defects of the bearing have a line");
}

FaultLines fault_lines(const EnvelopeSpectrum& spectrum, const signal::DatasetInfo& info,
                       double shaft_speed_rpm) {
  constexpr std::array fault_types{Defect::outer, Defect::inner, Defect::roller};
  FaultLines lines;
  if (!info.has_bearing) return lines;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    lines.at(i).fault_type = fault_types.at(i);
    lines.at(i).hz = bearing::impact_frequency_hz(info.bearing, fault_types.at(i), shaft_speed_rpm);
  }
  const std::vector<double> elsewhere = elsewhere_db(spectrum, lines);
  for (FaultLine& line : lines) {
    if (elsewhere.empty() || !spectra::can_measure_common_line(spectrum, line.hz)) continue;
    const CommonLine found = spectra::common_line(spectrum, line.hz);
    const double db = found.mean_db();
    const double places = 2 * line_tolerance * line_harmonics * line.hz / spectrum.resolution_hz;
    const auto as_far = std::ranges::count_if(elsewhere, [&](double other) { return other >= db; });
    line.db = db;
    line.noise_db = noise_line_db(spectrum.averages, places);
    line.farthest_factor = farthest_factor(spectrum, line.hz);
    line.share_elsewhere = static_cast<double>(as_far) / static_cast<double>(elsewhere.size());
    line.harmonics_above_noise = static_cast<int>(std::ranges::count_if(
        found.decibels, [&](double harmonic) { return harmonic > line.noise_db; }));
    line.stands_out = db > line.noise_db && line.harmonics_above_noise >= fewest_harmonics &&
                      line.share_elsewhere < largest_share_elsewhere;
  }
  return lines;
}

const FaultLine& line_of(const FaultLines& lines, Defect fault_type) {
  return *std::ranges::find(lines, fault_type, &FaultLine::fault_type);
}

const FaultLine* farthest(const FaultLines& lines) {
  const FaultLine* best = nullptr;
  for (const FaultLine& line : lines) {
    if (line.stands_out && (best == nullptr || *line.db > *best->db)) best = &line;
  }
  return best;
}

}  // namespace piae::inspection
