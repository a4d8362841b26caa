#pragma once

#include <cstddef>
#include <span>

namespace piae::inspection {

/// Stretches that hold the same samples as an earlier stretch of the record.
struct Repeats {
  std::size_t count = 0;
  std::size_t samples = 0;   ///< in all of them
  std::size_t longest = 0;   ///< samples
  std::size_t first = 0;     ///< first sample of the longest, counted from 0
  std::size_t original = 0;  ///< first sample of what it repeats
};

/// Finds stretches of 64 samples or more that repeat an earlier stretch exactly, and in which the
/// signal turns at least 32 times. Noise of one step of the converter makes two samples agree with
/// a probability of 0.28 at most, so 32 turns agree by chance with 2e-18, and two of the 5e13 pairs
/// of places in a record of 1e7 samples with 1e-4. Counting turns, not samples, leaves out what
/// repeats without a copy: a constant, and the slopes of a slow signal in coarse steps.
///
/// Takes a time of about 32 n and the memory of n / 32 hashes for n samples: blocks of 32 samples
/// are kept, and each place of the record is compared with those that lie before it.
Repeats repeats(std::span<const double> samples);

}  // namespace piae::inspection
