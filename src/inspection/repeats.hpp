#pragma once

#include <cstddef>
#include <span>

namespace piae::inspection {

/// Stretches with the same samples as an earlier stretch of the record.
struct Repeats {
  std::size_t count = 0;
  std::size_t samples = 0;   ///< in all of them
  std::size_t longest = 0;   ///< samples
  std::size_t first = 0;     ///< first sample of the longest, counted from 0
  std::size_t original = 0;  ///< first sample of the stretch that it repeats
};

/// Finds stretches of at least 64 samples that repeat an earlier stretch exactly and in which the
/// signal turns at least 32 times. Noise of one converter step makes two samples agree with a
/// probability of 0.28 at most. So 32 turns agree by chance with 2e-18, and any two of the 5e13
/// pairs of places in a record of 1e7 samples with 1e-4. Counting turns instead of samples ignores
/// repeats without a copy: constants, and slopes of a slow signal in coarse steps.
///
/// Takes about 32 n steps and n / 32 stored hashes for n samples: blocks of 32 samples are stored,
/// and each place of the record is compared with the blocks before it.
Repeats repeats(std::span<const double> samples);

}  // namespace piae::inspection
