#pragma once

#include <cstddef>
#include <span>

namespace piae::inspection {

/// Samples far from their neighbours and from the rest of the record.
struct LoneSamples {
  std::size_t count = 0;
  std::size_t farthest = 0;  ///< index of the one farthest from the mean, from 0
  double value = 0;          ///< of that sample
  double others = 0;         ///< largest distance of the other samples from the mean
};

/// Finds spikes of one sample or of two adjacent samples. A spike is ten times as far from the
/// middle of its eight neighbours on either side as any of these; the farther of two is a hundred
/// times as far. A spike is also farther from the mean than every sample with ordinary neighbours.
/// Up to ten first samples count, too, if each is three times as far from the mean as all others:
/// numbers of a header that has the format of the samples.
///
/// Vibration cannot have spikes. Recorders remove frequencies above 0.45 of the sample rate. The
/// narrowest remaining pulse is sin(0.9 pi n) / (0.9 pi n), whose neighbours reach 0.11 of its
/// height. Two such pulses, one sample apart, nearly cancel: their neighbours reach 0.014 of the
/// height. Fault impacts also ring for several samples. Normal noise has such a sample once in 1e12
/// samples.
LoneSamples lone_samples(std::span<const double> samples);

}  // namespace piae::inspection
