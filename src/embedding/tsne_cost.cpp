#include "embedding/tsne_cost.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/parallel.hpp"
#include "base/vector.hpp"

namespace piae::embedding {

using Eigen::Index;

namespace {

/// Pairs that a thread takes at once, a third of a millisecond of work. A smaller step runs on one
/// thread: on a busy machine, waiting for the slowest thread costs more than the step.
constexpr Index pairs_at_once = 1 << 20;

/// Position of the points that fill up the last vector of a row. They are far enough away to have
/// no effect, but near enough that their squared weights are not denormal numbers, which are slow.
constexpr float far_away = 1e9F;

/// Probabilities below this count as 0. Their products with weights would be denormal, and their
/// sum is below the rounding of single precision.
constexpr double least_probability = 1e-20;

/// Effect of all points on point i. The attraction is sum p_ij w_ij (y_i - y_j); the repulsion is
/// sum w_ij^2 (y_i - y_j), to be divided by the sum of all weights.
struct Pull {
  double attraction[2];
  double repulsion[2];
  double weights;  ///< sum w_ij, including the 1 of i = j
};

double sum_of_lanes(Vector<float> vector) {
  float numbers[lanes<float>];
  store<float>(numbers, vector);
  double sum = 0;
  for (const float number : numbers) sum += number;
  return sum;
}

/// `count` must be a multiple of the lanes of a vector.
Pull pull_on(float at_x, float at_y, const float* p, const float* x, const float* y, Index count) {
  Vector<float> attraction_x{};
  Vector<float> attraction_y{};
  Vector<float> repulsion_x{};
  Vector<float> repulsion_y{};
  Vector<float> weights{};
  for (Index j = 0; j < count; j += lanes<float>) {
    const Vector<float> dx = at_x - load(x + j);
    const Vector<float> dy = at_y - load(y + j);
    const Vector<float> w = 1.0F / (1.0F + dx * dx + dy * dy);
    const Vector<float> attracting = load(p + j) * w;
    const Vector<float> repelling = w * w;
    attraction_x += attracting * dx;
    attraction_y += attracting * dy;
    repulsion_x += repelling * dx;
    repulsion_y += repelling * dy;
    weights += w;
  }
  return {{sum_of_lanes(attraction_x), sum_of_lanes(attraction_y)},
          {sum_of_lanes(repulsion_x), sum_of_lanes(repulsion_y)},
          sum_of_lanes(weights)};
}

}  // namespace

double kl_divergence(const Eigen::MatrixXd& probabilities, const Plane& points) {
  const Index n = points.rows();
  Eigen::ArrayXd of_row(n);   // sum_j p_ij ln(p_ij / w_ij)
  Eigen::ArrayXd weights(n);  // sum_j w_ij without j = i
  parallel_for(static_cast<std::size_t>(n), [&](std::size_t point) {
    const auto i = static_cast<Index>(point);
    double sum = 0;
    double weight = 0;
    for (Index j = 0; j < n; ++j) {
      if (j == i) continue;
      const double p = probabilities(j, i);
      const double inverse_weight = 1 + (points.row(i) - points.row(j)).square().sum();
      weight += 1 / inverse_weight;
      if (p > 0) sum += p * std::log(p * inverse_weight);
    }
    of_row[i] = sum;
    weights[i] = weight;
  });
  return of_row.sum() + probabilities.sum() * std::log(weights.sum());
}

KlGradient::KlGradient(const Eigen::MatrixXd& probabilities) {
  const Index n = probabilities.rows();
  probabilities_.setZero(n, whole_rows(n));
  probabilities_.leftCols(n) =
      (probabilities.array() < least_probability).select(0, probabilities).cast<float>();
}

Plane KlGradient::operator()(const Plane& points, double exaggeration) const {
  const Index n = points.rows();
  const Index whole = probabilities_.cols();
  Eigen::ArrayX2f filled_up = Eigen::ArrayX2f::Constant(whole, 2, far_away);
  filled_up.topRows(n) = points.cast<float>();
  const float* const x = filled_up.data();
  const float* const y = x + whole;

  Plane attraction(n, 2);
  Plane repulsion(n, 2);
  Eigen::ArrayXd weights(n);
  const auto pull_rows = [&](std::size_t first, std::size_t count) {
    for (auto i = static_cast<Index>(first); i < static_cast<Index>(first + count); ++i) {
      const Pull pull = pull_on(x[i], y[i], probabilities_.row(i).data(), x, y, whole);
      attraction.row(i) << pull.attraction[0], pull.attraction[1];
      repulsion.row(i) << pull.repulsion[0], pull.repulsion[1];
      weights[i] = pull.weights - 1;
    }
  };
  const auto rows = static_cast<std::size_t>(n);
  const auto rows_at_once = static_cast<std::size_t>(std::max(pairs_at_once / whole, Index{1}));
  if (rows <= rows_at_once) {
    pull_rows(0, rows);
  } else {
    parallel_for_parts(1, rows, rows_at_once, pull_rows);
  }
  return 4 * (exaggeration * attraction - repulsion / weights.sum());
}

}  // namespace piae::embedding
