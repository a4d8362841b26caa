#include "diagnosis/band_powers.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <span>

#include "base/error.hpp"
#include "spectra/bands.hpp"
#include "spectra/power.hpp"

namespace piae::diagnosis {

using Eigen::Index;

FeatureRows band_powers(const signal::WindowSet& windows) {
  const auto length = static_cast<Index>(windows.length);
  if (length < 2 * number_of_bands) {
    throw Error(Exit::bad_input,
                fmt::format("windows of {} samples: {} bands need {} samples or more",
                            windows.length, number_of_bands, 2 * number_of_bands));
  }
  const Index bins = length / 2;
  std::vector<Index> edges;
  for (Index band = 0; band <= number_of_bands; ++band) {
    edges.push_back(band * bins / number_of_bands);
  }
  FeatureRows features(static_cast<Index>(windows.size()), number_of_bands);
  for (Index i = 0; i < features.rows(); ++i) {
    const auto samples = windows.window(static_cast<std::size_t>(i));
    const spectra::Windows window =
        Eigen::Map<const Eigen::RowVectorXf>(samples.data(), length).cast<double>();
    const Eigen::ArrayXd power = spectra::mean_power_spectrum(window).tail(bins);
    const double floor = 1e-12 * power.mean() + 1e-300;  // keeps silent bands far away, but finite
    features.row(i) = spectra::band_means(power, edges).unaryExpr([&](double mean) {
      return std::log(mean + floor);
    });
    features.row(i).array() -= features.row(i).mean();
  }
  return features;
}

Eigen::MatrixXd Neighbours::squared_distances(const FeatureRows& queries) const {
  Eigen::MatrixXd squares = known_ * (-2 * queries.transpose());
  squares.colwise() += squares_;
  squares.rowwise() += squares_of(queries).transpose();
  return squares.cwiseMax(0);  // rounding may make them negative
}

void write_bands(artefact::Writer& writer, const std::string& group, const FeatureRows& rows,
                 const std::vector<Label>& labels) {
  const std::span<const double> values(rows.data(), static_cast<std::size_t>(rows.size()));
  writer.numbers(group + "/bands", values, {labels.size(), static_cast<std::size_t>(rows.cols())});
  writer.numbers(group + "/labels", labels);
}

std::vector<Label> read_labels(const artefact::Reader& reader, const std::string& group,
                               const signal::DatasetInfo& info) {
  const std::string path = group + "/labels";
  std::vector<Label> labels = reader.numbers<Label>(path, {0}).values;
  if (labels.empty()) reader.refuse(path, "is empty");
  for (const Label label : labels) {
    if (label < 0 || index_of(label) >= info.classes.size()) {
      reader.refuse(path, "has a label without a class");
    }
  }
  return labels;
}

FeatureRows read_bands(const artefact::Reader& reader, const std::string& group, std::size_t n,
                       Index columns) {
  const auto bands =
      reader.numbers<double>(group + "/bands", {n, static_cast<std::size_t>(columns)});
  return Eigen::Map<const FeatureRows>(bands.values.data(), static_cast<Index>(n), columns);
}

}  // namespace piae::diagnosis
