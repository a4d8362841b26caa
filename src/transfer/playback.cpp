#include "transfer/playback.hpp"

#include <algorithm>
#include <cmath>

#include "signal/resample.hpp"

namespace piae::transfer {

namespace {

/// The resampler fades in and out over some hundred samples, of the slower side.
constexpr double fade_samples = 512;

}  // namespace

std::vector<double> played(std::span<const float> window, std::size_t start, double factor) {
  const std::size_t length = window.size();
  const auto lead = static_cast<std::size_t>(std::ceil(fade_samples / std::min(factor, 1.0)));
  const auto before = static_cast<std::size_t>(std::ceil(static_cast<double>(lead) * factor));
  std::vector<double> source(
      before + static_cast<std::size_t>(std::ceil(static_cast<double>(lead + length) * factor)) +
      1);
  const std::size_t first = start + length - before % length;
  for (std::size_t i = 0; i < source.size(); ++i) source[i] = window[(first + i) % length];
  const std::vector<double> all = signal::resample(source, factor, 1);
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(lead);
  return {begin, begin + static_cast<std::ptrdiff_t>(length)};
}

}  // namespace piae::transfer
