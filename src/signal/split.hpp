#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "artefact/writer.hpp"
#include "cli/options.hpp"
#include "signal/recordings.hpp"
#include "signal/window_set.hpp"

namespace piae::signal {

/// How windows are cut and shared out (paper, Section 4.2 and Table 2).
struct SplitOptions {
  std::int64_t seed = 0;            ///< the repeat; each seed has a split of its own
  std::string protocol = "random";  ///< "random" or "blocked", see split()
  std::size_t window = 1024;        ///< samples
  std::size_t max_stride = 512;     ///< samples between the starts of two windows, at most
  std::size_t windows_per_class = 600;
  std::size_t test_per_class = 100;  ///< A, of every class
  std::size_t known_per_class = 5;   ///< C, of every fault class
  std::size_t guard_windows = 1;     ///< window lengths left unused between roles; blocked only
};

/// Binds --seed, --protocol, --window and so on. --seed is required.
void bind(const cli::Options& command, SplitOptions& options);

/// The windows of the roles. With the paper's numbers: A 100 of every class (test), B the other 500
/// of the healthy class, C 5 of every fault class (known), D the other 495 of every fault class.
struct Split {
  static constexpr std::array<const char*, 4> roles{"A", "B", "C", "D"};
  std::array<WindowSet, 4> sets;      ///< in that order
  std::vector<std::int64_t> strides;  ///< samples, one for each class
};

/// Cuts every class at the largest stride up to max_stride that gives windows_per_class windows
/// over all of its records; a record of n samples contributes floor((n - window) / stride) + 1.
/// Protocols:
///   random   the paper's: a random permutation of the class's windows is dealt out. At a stride
///            below the window's length, windows of different roles overlap.
///   blocked  the class's windows in time order, begun at a random one, are cut into blocks
///            A, C, D (healthy: A, B). So many windows are left out after each block that at least
///            guard_windows window lengths of a record lie unused between two roles; the stride is
///            chosen so that these fit too.
/// Random numbers come from the stream "<dataset>/seed<k>/split/<class>". Windows keep the unit of
/// the recording, and the true (k, c) where all records have them. Throws Error(usage) for options
/// that contradict each other, Error(bad_input) naming the class and the number of windows that do
/// fit where its records are too short.
Split split(const Recordings& recordings, const SplitOptions& options);

/// Writes one role: the window set, /classes/stride, and the root attributes role, protocol, seed
/// and records_digest (content digest of the records that were split).
void write(artefact::Writer& writer, const Split& split, std::size_t role,
           const SplitOptions& options, const std::string& records_digest);

}  // namespace piae::signal
