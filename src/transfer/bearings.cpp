#include "transfer/bearings.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

#include "spectra/power.hpp"

namespace piae::transfer {

namespace {

using Eigen::Index;

constexpr Index steps = 4;    ///< from the first piece to the last, a quarter of a piece each
constexpr Index padding = 4;  ///< from half a window to a frame of two

/// Pieces of half a window, a row for each.
spectra::Windows pieces_of(const signal::WindowSet& known, const std::vector<std::size_t>& own) {
  const auto length = static_cast<Index>((known.length + 1) / 2);
  const Index step = (static_cast<Index>(known.length) - length) / steps;
  const Index in_a_window = steps + 1;
  spectra::Windows pieces(static_cast<Index>(own.size()) * in_a_window, length);
  Index row = 0;
  for (const std::size_t i : own) {
    const Eigen::Map<const Eigen::RowVectorXf> window(known.window(i).data(),
                                                      static_cast<Index>(known.length));
    for (Index j = 0; j < in_a_window; ++j) {
      pieces.row(row++) = window.segment(j * step, length).cast<double>();
    }
  }
  return pieces;
}

}  // namespace

std::vector<KnownBearing> bearings_of(const signal::WindowSet& known) {
  std::map<std::tuple<Label, double, double>, std::vector<std::size_t>> windows;
  for (std::size_t i = 0; i < known.size(); ++i) {
    windows[{known.labels[i], known.speed_rpm(i), known.size_mm(i)}].push_back(i);
  }
  std::vector<KnownBearing> bearings;
  for (auto& [what, own] : windows) {
    const auto [label, speed_rpm, size_mm] = what;
    bearings.push_back(
        {.label = label, .speed_rpm = speed_rpm, .size_mm = size_mm, .windows = std::move(own)});
  }
  return bearings;
}

bool tests_other_bearings(const signal::WindowSet& known) {
  return !known.defect_size_mm.empty() &&
         std::ranges::any_of(known.info.conditions, [](const auto& condition) {
           return condition.test && !condition.known;
         });
}

Eigen::ArrayXd log_amplitude(const signal::WindowSet& known, const KnownBearing& bearing) {
  const Eigen::ArrayXd power =
      spectra::mean_power_spectrum(pieces_of(known, bearing.windows), padding);
  const double silence = std::numeric_limits<double>::min();
  return (power + silence).log() / 2;
}

}  // namespace piae::transfer
