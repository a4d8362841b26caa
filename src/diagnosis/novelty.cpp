#include "diagnosis/novelty.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "base/columns.hpp"
#include "diagnosis/band_powers.hpp"
#include "spectra/left_out.hpp"

namespace piae::diagnosis {

namespace {

using Eigen::Index;

constexpr double margin = 1;
constexpr double least_threshold = 1e-6;  // if all reference windows are the same
constexpr Range possible_threshold{.low = least_threshold, .high = 1e6};

}  // namespace

Novelty::Novelty(const signal::WindowSet& reference, std::vector<std::int32_t> groups)
    : Novelty(band_powers(reference), reference.labels, std::move(groups)) {}

Novelty::Novelty(FeatureRows bands, std::vector<Label> labels, std::vector<std::int32_t> groups)
    : labels_(std::move(labels)),
      groups_(std::move(groups)),
      reference_(std::move(bands)),
      threshold_(spectra::left_out_threshold(largest_left_out(), margin, least_threshold)) {}

double Novelty::largest_left_out() const {
  double largest = 0;
  const Eigen::MatrixXd squares = reference_.squared_distances(reference_.known());
  for (Index i = 0; i < squares.cols(); ++i) {
    double nearest = std::numeric_limits<double>::infinity();
    for (Index j = 0; j < squares.rows(); ++j) {
      if (groups_[static_cast<std::size_t>(i)] == groups_[static_cast<std::size_t>(j)]) continue;
      nearest = std::min(nearest, squares(j, i));
    }
    largest = std::max(largest, nearest);
  }
  if (!std::isfinite(largest)) throw std::logic_error("all reference windows belong to one group");
  return std::sqrt(largest);
}

std::vector<double> Novelty::of(const signal::WindowSet& windows) const {
  const FeatureRows tested = band_powers(windows);
  std::vector<double> all;
  all.reserve(windows.size());
  for (Index begin = 0; begin < tested.rows(); begin += Neighbours::at_a_time) {
    const Index count = std::min(Neighbours::at_a_time, tested.rows() - begin);
    const Eigen::RowVectorXd nearest =
        reference_.squared_distances(tested.middleRows(begin, count)).colwise().minCoeff();
    for (const double square : nearest) all.push_back(std::sqrt(square) / threshold_);
  }
  return all;
}

Novelty Novelty::without(Label label) const {
  std::vector<Index> rows;
  std::vector<Label> labels;
  std::vector<std::int32_t> groups;
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    if (labels_[i] == label) continue;
    rows.push_back(static_cast<Index>(i));
    labels.push_back(labels_[i]);
    groups.push_back(groups_[i]);
  }
  return {reference_.known()(rows, every_column(reference_.known())), std::move(labels),
          std::move(groups)};
}

void Novelty::write(artefact::Writer& writer, const std::string& group) const {
  write_bands(writer, group, reference_.known(), labels_);
  writer.numbers(group + "/groups", groups_);
  writer.attribute(group, "threshold", threshold_);
}

Novelty::Novelty(const artefact::Reader& reader, const std::string& group,
                 const signal::DatasetInfo& info)
    : labels_(read_labels(reader, group, info)),
      groups_(reader.numbers<std::int32_t>(group + "/groups", {labels_.size()}).values),
      reference_(read_bands(reader, group, labels_.size())),
      threshold_(reader.real(group, "threshold", possible_threshold)) {}

}  // namespace piae::diagnosis
