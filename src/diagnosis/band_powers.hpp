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

/// Numbers by which windows are compared, one row for each window.
using FeatureRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Returns [n, 128]: the logarithm of each window's power in 128 bands of equal width under Hann's
/// window, without the bin of the offset. The mean over the bands is removed, so neither the level
/// nor the start angle of a window matters. Windows are compared by Euclidean distance of these
/// rows. Throws Error(bad_input) for windows shorter than 256 samples.
FeatureRows band_powers(const signal::WindowSet& windows);

inline constexpr Eigen::Index number_of_bands = 128;

/// Searches the nearest among known windows.
class Neighbours {
 public:
  /// Number of windows per matrix product; their distances fit into the caches.
  static constexpr Eigen::Index at_a_time = 64;

  explicit Neighbours(FeatureRows known) : known_(std::move(known)), squares_(squares_of(known_)) {}

  /// Returns [known, queries] the squared distance of each known window to each window of
  /// `queries`.
  [[nodiscard]] Eigen::MatrixXd squared_distances(const FeatureRows& queries) const;

  [[nodiscard]] const FeatureRows& known() const { return known_; }

 private:
  static Eigen::VectorXd squares_of(const FeatureRows& windows) {
    return windows.rowwise().squaredNorm();
  }

  FeatureRows known_;
  Eigen::VectorXd squares_;
};

/// Writes the rows of windows and their labels, as <group>/bands float64 [n, columns] and
/// <group>/labels.
void write_bands(artefact::Writer& writer, const std::string& group, const FeatureRows& rows,
                 const std::vector<Label>& labels);

/// Throws artefact::Refusal if labels are missing, or a label has no class.
std::vector<Label> read_labels(const artefact::Reader& reader, const std::string& group,
                               const signal::DatasetInfo& info);
/// Throws artefact::Refusal for another shape.
FeatureRows read_bands(const artefact::Reader& reader, const std::string& group, std::size_t n,
                       Eigen::Index columns = number_of_bands);

}  // namespace piae::diagnosis
