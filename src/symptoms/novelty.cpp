#include "symptoms/novelty.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/columns.hpp"
#include "spectra/left_out.hpp"
#include "symptoms/speed_change.hpp"

namespace piae::symptoms {

namespace {

using Eigen::Index;

constexpr Index blocks = 4;
constexpr double margin = 1.2;
constexpr double common_share = 0.5;         // of the mean deviation, added to each band's own
constexpr double least_deviation_db = 1e-6;  // if all healthy windows are the same

/// Returns the rows outside a block.
Eigen::ArrayXXd without_block(const Eigen::ArrayXXd& rows, Index block) {
  std::vector<Index> others;
  for (Index i = 0; i < rows.rows(); ++i) {
    if (spectra::block_of(i, rows.rows(), blocks) != block) others.push_back(i);
  }
  return rows(others, every_column(rows));
}

}  // namespace

double Novelty::Likeness::distance(const Eigen::ArrayXd& shape) const {
  return std::sqrt(((shape - mean) / deviation).square().mean());
}

Novelty::Likeness Novelty::likeness(const Eigen::ArrayXXd& shapes) {
  const Eigen::ArrayXd mean = shapes.colwise().mean();
  const Eigen::ArrayXd variance = (shapes.rowwise() - mean.transpose()).square().colwise().mean();
  const double common = std::max(common_share * variance.sqrt().mean(), least_deviation_db);
  return {.mean = mean, .deviation = (variance + common * common).sqrt()};
}

Novelty::Novelty(const Eigen::ArrayXXd& healthy, double speed_ratio)
    : all_(likeness(healthy)), of_healthy_(healthy.rows()) {
  for (Index block = 0; block < blocks; ++block) {
    const Likeness others = likeness(without_block(healthy, block));
    for (Index i = 0; i < healthy.rows(); ++i) {
      if (spectra::block_of(i, healthy.rows(), blocks) == block) {
        of_healthy_[i] = others.distance(healthy.row(i).transpose());
      }
    }
  }
  threshold_ = spectra::left_out_threshold(of_healthy_.maxCoeff(), margin, least_deviation_db);
  of_healthy_ /= threshold_;
  if (speed_ratio == 1) return;
  const Eigen::ArrayXd change = change_db(all_.mean, places_of_shape(), speed_ratio);
  all_.deviation = (all_.deviation.square() + change.square()).sqrt();
}

double Novelty::of(const Eigen::ArrayXd& shape) const { return all_.distance(shape) / threshold_; }

}  // namespace piae::symptoms
