#pragma once

#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/label.hpp"
#include "diagnosis/neighbours.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// A window that is stranger than this looks like nothing that was trained.
inline constexpr double strangest_known = 1;

/// Whether a window looks like anything that was trained: its distance to the nearest reference
/// window by band powers (Neighbours), by a threshold. The threshold is the largest distance that a
/// reference window has to the others when what is close to it in time is left out: each known
/// fault window alone, and the healthy ones by five blocks of the time, so that windows that
/// overlap do not vouch for each other.
class Strangeness {
 public:
  /// `reference` are healthy windows and those of faults, of which `groups` says what is left out
  /// together. Throws Error(bad_input) for windows shorter than 256 samples; std::logic_error where
  /// all are of one group.
  Strangeness(const signal::WindowSet& reference, std::vector<std::int32_t> groups);

  /// [n] of each window; more than 1 looks like nothing that was trained.
  [[nodiscard]] std::vector<double> of(const signal::WindowSet& windows) const;
  /// The same if the class had not been trained: without its windows, and a threshold of the rest.
  [[nodiscard]] Strangeness without(Label label) const;

  /// As <group>/bands, <group>/labels, <group>/groups and the attribute `threshold`.
  void write(artefact::Writer& writer, const std::string& group) const;
  Strangeness(const artefact::Reader& reader, const std::string& group,
              const signal::DatasetInfo& info);

 private:
  Strangeness(BandPowers bands, std::vector<Label> labels, std::vector<std::int32_t> groups);
  [[nodiscard]] double largest_left_out() const;

  std::vector<Label> labels_;
  std::vector<std::int32_t> groups_;
  Neighbours reference_;
  double threshold_;  ///< a distance
};

}  // namespace piae::diagnosis
