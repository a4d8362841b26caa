#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "artefact/writer.hpp"
#include "base/range.hpp"
#include "cli/options.hpp"
#include "signal/protocol.hpp"
#include "signal/recordings.hpp"
#include "signal/roles.hpp"
#include "signal/sources.hpp"
#include "signal/window_set.hpp"

namespace piae::signal {

/// How windows are cut and dealt out to the roles (paper, Section 4.2 and Table 2).
struct SplitOptions {
  std::int64_t seed = 0;                 ///< the repeat; each seed has a split of its own
  Protocol protocol = Protocol::random;  ///< see split()
  std::size_t window = 1024;             ///< samples
  std::size_t max_stride = 512;          ///< samples between the starts of two windows, at most
  std::size_t windows_per_class = 600;
  std::size_t test_per_class = 100;  ///< windows of every class in A
  std::size_t known_per_class = 5;   ///< windows of every fault class in C; 0: no fault is known
  std::size_t guard_windows = 1;     ///< window lengths left unused between roles; blocked only
};

/// Binds --seed, --protocol, --window and so on. --seed is required.
void bind(const cli::Options& command, SplitOptions& options);

/// Of the settings that which decides whether any fault window is known.
inline constexpr const char* known_per_class = "known-per-class";

/// Those of the options that a data set may set for itself, in [split] of its description, without
/// the dashes; and what each of them may be.
struct SplitSetting {
  std::string name;
  Range range;
};
std::vector<SplitSetting> split_settings();

/// Sets one of these. Throws std::logic_error for another name.
void set(SplitOptions& options, const std::string& name, std::size_t value);

/// Throws Error(usage) for options that contradict each other.
void require_sensible(const SplitOptions& options);

/// What of these concerns one class.
Counts counts_of(const SplitOptions& options);

/// A dataset dealt out to the four roles. With the paper's numbers A has 100 windows of every
/// class, B the other 500 of the healthy class, C 5 of every fault class, and D the other 495 of
/// every fault class. Where no window is to be known, C has none, and all else is as always.
struct Split {
  std::array<WindowSet, split_roles.size()> sets;  ///< in the order of split_roles
  /// Samples between two windows, for each class by label; the least one where its conditions are
  /// cut apart.
  std::vector<std::int64_t> strides;

  [[nodiscard]] WindowSet& of(Role role) { return sets.at(static_cast<std::size_t>(role)); }
  [[nodiscard]] const WindowSet& of(Role role) const {
    return sets.at(static_cast<std::size_t>(role));
  }
};

/// Cuts every class at the largest stride up to max_stride at which its records together give
/// windows_per_class windows, and deals these out. A record of n samples, or a piece of one that
/// has pieces, gives floor((n - window) / stride) + 1 windows. Protocols:
///   random   The paper's: the windows of the class are dealt out in a random order. Where the
///            stride is below the window length, windows of different roles overlap.
///   blocked  The windows of the class are dealt out in time order, beginning at a random one and
///            going on at the first after the last: a block for A, one for C, one for D (healthy
///            class: A, B). After each block windows are left out, so that at least guard_windows
///            window lengths of a record lie unused between two roles. The stride is small enough
///            for these gaps too.
/// Where the dataset tells conditions apart, all of this is done for each of them by itself, with
/// the part of the windows that it has to give (sources.hpp): A and D come from tested conditions
/// alone, C from known ones, B from those for healthy windows.
/// Random numbers come from the stream "<dataset>/seed<k>/split/<class>". Windows keep the unit of
/// the recording, and the true (k, c) where all records have them. Throws as
/// require_sensible(), and Error(bad_input) where the records of a class are too short; the
/// line names the class and how many windows do fit.
Split split(const Recordings& recordings, const SplitOptions& options);

/// Writes the windows of one role with /classes/stride, and as attributes of the root role,
/// protocol, seed and records_digest (content digest of the recordings that were split).
void write(artefact::Writer& writer, const Split& split, Role role, const SplitOptions& options,
           const std::string& records_digest);

}  // namespace piae::signal
