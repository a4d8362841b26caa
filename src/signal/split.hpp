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

/// Options for cutting windows and assigning them to roles (paper, Section 4.2 and Table 2).
struct SplitOptions {
  std::int64_t seed = 0;                 ///< the repeat; each seed has its own split
  Protocol protocol = Protocol::random;  ///< see split()
  std::size_t window = 1024;             ///< samples
  std::size_t max_stride = 512;          ///< most samples between the starts of two windows
  std::size_t windows_per_class = 600;
  std::size_t test_per_class = 100;  ///< windows of every class in A
  std::size_t known_per_class = 5;   ///< windows of every fault class in C; 0: no fault is known
  std::size_t guard_windows = 1;     ///< window lengths left unused between roles; blocked only
};

/// Binds --seed, --protocol, --window and so on. --seed is required.
void bind(const cli::Options& command, SplitOptions& options);

/// Name of the setting that decides whether fault windows are known.
inline constexpr const char* known_per_class = "known-per-class";

/// An option that a data set may set in [split] of its description, without dashes, and its
/// permitted values.
struct SplitSetting {
  std::string name;
  Range range;
};
std::vector<SplitSetting> split_settings();

/// Sets a setting by its name. Throws std::logic_error for an unknown name.
void set(SplitOptions& options, const std::string& name, std::size_t value);

/// Throws Error(usage) for options that contradict each other.
void require_sensible(const SplitOptions& options);

/// Returns the counts for one class.
Counts counts_of(const SplitOptions& options);

/// A data set split into the four roles. With the paper's numbers A has 100 windows of every class,
/// B the other 500 healthy windows, C 5 of every fault class, and D the other 495. Without known
/// windows C is empty, and the other roles are as always.
struct Split {
  std::array<WindowSet, split_roles.size()> sets;  ///< in the order of split_roles
  /// Samples between the starts of two windows, for each class by label. If conditions are split
  /// separately: the smallest stride.
  std::vector<std::int64_t> strides;

  [[nodiscard]] WindowSet& of(Role role) { return sets.at(static_cast<std::size_t>(role)); }
  [[nodiscard]] const WindowSet& of(Role role) const {
    return sets.at(static_cast<std::size_t>(role));
  }
};

/// Cuts every class at the largest stride up to max_stride that gives windows_per_class windows,
/// and assigns these to roles. A record or piece of n samples gives floor((n - window) / stride) +
/// 1 windows. Protocols:
///   random   The paper's: the windows of a class are assigned in random order. If the stride is
///            below the window length, windows of different roles overlap.
///   blocked  The windows of a class are assigned in time order, from a random one on and
///            wrapping round at the end: a block for A, one for C, one for D (healthy class: A, B).
///            Windows after each block are left out, so that at least guard_windows window lengths
///            of a record lie unused between two roles. The stride allows for these gaps.
/// If the data set distinguishes conditions, each is split separately, with its share of the
/// windows (sources.hpp): A and D come only from tested conditions, C from known ones, B from those
/// for healthy windows. Random numbers come from the stream "<dataset>/seed<k>/split/<class>".
/// Windows keep the unit of the recording, and the true (k, c) if all records have them. With
/// conditions, or if Recordings::have_speeds(), each has the mean speed of its own time. Throws as
/// require_sensible(), and Error(bad_input) if the records of a class are too short; the message
/// names the class and how many windows fit.
Split split(const Recordings& recordings, const SplitOptions& options);

/// Writes the windows of one role and /classes/stride. Root attributes: role, protocol, seed and
/// records_digest (content digest of the recordings that were split).
void write(artefact::Writer& writer, const Split& split, Role role, const SplitOptions& options,
           const std::string& records_digest);

}  // namespace piae::signal
