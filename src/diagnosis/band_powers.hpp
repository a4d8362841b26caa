#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/label.hpp"
#include "signal/dataset_info.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// One row for each window.
using BandPowers = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Returns [n, 128]: the logarithm of each window's power in 128 bands of equal width under Hann's
/// window, without the bin of the offset. The mean over the bands is removed, so neither the level
/// nor the start angle of a window matters. Windows are compared by Euclidean distance of these
/// rows. Throws Error(bad_input) for windows shorter than 256 samples.
BandPowers band_powers(const signal::WindowSet& windows);

inline constexpr Eigen::Index number_of_bands = 128;

/// Searches the nearest among known windows, by band powers.
class Neighbours {
 public:
  /// Number of windows per matrix product; their distances fit into the caches.
  static constexpr Eigen::Index at_a_time = 64;

  explicit Neighbours(BandPowers known) : known_(std::move(known)), squares_(squares_of(known_)) {}

  /// Returns [known, queries] the squared distance of each known window to each window of
  /// `queries`.
  [[nodiscard]] Eigen::MatrixXd squared_distances(const BandPowers& queries) const;

  [[nodiscard]] const BandPowers& known() const { return known_; }

 private:
  static Eigen::VectorXd squares_of(const BandPowers& windows) {
    return windows.rowwise().squaredNorm();
  }

  BandPowers known_;
  Eigen::VectorXd squares_;
};

/// Writes band powers of windows and their labels, as <group>/bands float64 [n, 128] and
/// <group>/labels.
void write_bands(artefact::Writer& writer, const std::string& group, const BandPowers& bands,
                 const std::vector<Label>& labels);

/// Throws artefact::Refusal if labels are missing, or a label has no class.
std::vector<Label> read_labels(const artefact::Reader& reader, const std::string& group,
                               const signal::DatasetInfo& info);
/// Throws artefact::Refusal for another shape.
BandPowers read_bands(const artefact::Reader& reader, const std::string& group, std::size_t n);

}  // namespace piae::diagnosis
