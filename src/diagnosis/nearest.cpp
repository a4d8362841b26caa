#include "diagnosis/nearest.hpp"

#include <spdlog/fmt/fmt.h>

#include <Eigen/Core>
#include <cmath>

#include "base/error.hpp"
#include "scoring/spectrum.hpp"

namespace piae::diagnosis {

namespace {

using Eigen::Index;
using Bands = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr Index bands = 128;

/// The features of each window, a row for each.
Bands bands_of(const signal::WindowSet& windows) {
  const auto length = static_cast<Index>(windows.length);
  const Index bins = length / 2;  // without the first: a sensor's offset is no vibration
  Bands features(static_cast<Index>(windows.size()), bands);
  for (Index i = 0; i < features.rows(); ++i) {
    const auto samples = windows.window(static_cast<std::size_t>(i));
    const scoring::Windows window =
        Eigen::Map<const Eigen::RowVectorXf>(samples.data(), length).cast<double>();
    const Eigen::ArrayXd power = scoring::mean_power_spectrum(window).tail(bins);
    const double floor = 1e-12 * power.mean() + 1e-300;  // silence is far away, not infinitely far
    for (Index band = 0; band < bands; ++band) {
      const Index from = band * bins / bands;
      const Index count = (band + 1) * bins / bands - from;
      features(i, band) = std::log(power.segment(from, count).mean() + floor);
    }
    features.row(i).array() -= features.row(i).mean();
  }
  return features;
}

}  // namespace

std::vector<Label> classify_by_nearest(const signal::WindowSet& training,
                                       const signal::WindowSet& test) {
  if (training.length != test.length || static_cast<Index>(test.length) < 2 * bands) {
    throw Error(Exit::bad_input,
                fmt::format("windows of {} and {} samples: the nearest neighbour by {} bands needs "
                            "equal lengths, {} or more",
                            training.length, test.length, bands, 2 * bands));
  }
  const Bands known = bands_of(training);
  const Bands asked = bands_of(test);
  const Eigen::VectorXd squares = known.rowwise().squaredNorm();
  std::vector<Label> labels;
  for (Index i = 0; i < asked.rows(); ++i) {
    // The squared distances, but for the square of the window itself, which all have in common.
    Index nearest = 0;
    (squares - 2 * (known * asked.row(i).transpose())).minCoeff(&nearest);
    labels.push_back(training.labels[static_cast<std::size_t>(nearest)]);
  }
  return labels;
}

std::vector<float> scores_of_named(const std::vector<Label>& named, std::size_t classes) {
  std::vector<float> scores(named.size() * classes);
  for (std::size_t i = 0; i < named.size(); ++i) scores[i * classes + index_of(named[i])] = 1;
  return scores;
}

}  // namespace piae::diagnosis
