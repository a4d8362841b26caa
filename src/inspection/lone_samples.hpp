#pragma once

#include <cstddef>
#include <span>

namespace piae::inspection {

/// Samples that stand out of their neighbours and of the whole record.
struct LoneSamples {
  std::size_t count = 0;
  std::size_t farthest = 0;  ///< which one is the farthest from the mean, counted from 0
  double value = 0;          ///< of that sample
  double others = 0;         ///< the largest distance of all other samples from the mean
};

/// Finds spikes: samples ten times as far from the middle of their eight neighbours on either side
/// as any of these, and farther from the mean than every sample with ordinary neighbours.
///
/// A vibration cannot look so. Recorders remove what lies above 0.45 of the sample rate at the
/// latest, and the narrowest pulse that passes is sin(0.9 pi n) / (0.9 pi n), whose neighbours
/// reach 0.11 of its height. The impacts of a fault also ring for several samples. In normal noise,
/// a sample is ten times as far out as 16 neighbours once in 1e12 samples.
LoneSamples lone_samples(std::span<const double> samples);

}  // namespace piae::inspection
