#include "zero/background.hpp"

#include <cmath>

#include "transfer/equaliser.hpp"
#include "zero/draws.hpp"

namespace piae::zero {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;

ArrayXd about_its_mean(std::span<const float> window) {
  const ArrayXd samples =
      Eigen::Map<const Eigen::ArrayXf>(window.data(), static_cast<Index>(window.size()))
          .cast<double>();
  return samples - samples.mean();
}

double rms(const ArrayXd& window) { return std::sqrt(window.square().mean()); }

}  // namespace

ArrayXd draw_background(std::span<const float> healthy, double spread_db, Stream& random) {
  ArrayXd window = about_its_mean(healthy);
  window /= rms(window);
  if (happens(random, 0.5)) window.reverseInPlace();
  if (spread_db > 0) {
    transfer::equalise({window.data(), healthy.size()},
                       transfer::draw_gains(random, healthy.size() / 2 + 1,
                                            {.spread_db = spread_db, .knots = path_knots}));
  }
  return window;
}

std::vector<float> as_loud_as(std::span<const float> healthy, const ArrayXd& window) {
  const ArrayXd deviation = window - window.mean();
  const double loudness = rms(deviation);
  const Eigen::ArrayXf loud =
      (loudness > 0 ? ArrayXd(deviation * (rms(about_its_mean(healthy)) / loudness)) : deviation)
          .cast<float>();
  return {loud.begin(), loud.end()};
}

}  // namespace piae::zero
