#pragma once

#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/label.hpp"
#include "diagnosis/band_powers.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// Novelty above which a window resembles nothing in the training set.
inline constexpr double highest_known_novelty = 1;

/// Novelty of a window: its distance to the nearest reference window by band powers (Neighbours),
/// divided by a threshold. The threshold is the largest distance of a reference window to
/// the others, without those close to it in time: each known fault window is left out alone,
/// healthy windows by five blocks of time, so that overlapping windows do not vouch for each other.
class Novelty {
 public:
  /// Takes healthy and fault windows as `reference`; windows of one group in `groups` are left out
  /// together. Throws Error(bad_input) for windows shorter than 256 samples; std::logic_error if
  /// all windows are of one group.
  Novelty(const signal::WindowSet& reference, std::vector<std::int32_t> groups);

  /// Returns [n] the novelty of each window; more than 1 resembles nothing in the training set.
  [[nodiscard]] std::vector<double> of(const signal::WindowSet& windows) const;
  /// Returns the novelty as if the class had not been trained: without its windows, with a new
  /// threshold.
  [[nodiscard]] Novelty without(Label label) const;

  /// Writes <group>/bands, <group>/labels, <group>/groups and the attribute `threshold`.
  void write(artefact::Writer& writer, const std::string& group) const;
  Novelty(const artefact::Reader& reader, const std::string& group,
          const signal::DatasetInfo& info);

 private:
  Novelty(FeatureRows bands, std::vector<Label> labels, std::vector<std::int32_t> groups);
  [[nodiscard]] double largest_left_out() const;

  std::vector<Label> labels_;
  std::vector<std::int32_t> groups_;
  Neighbours reference_;
  double threshold_;  ///< a distance
};

}  // namespace piae::diagnosis
