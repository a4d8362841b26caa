#include "twin/losses.hpp"

#include <algorithm>
#include <cmath>

namespace piae::twin {

namespace {

using Eigen::Index;

/// The squared distances of all rows of z to each other, [n, n].
template <class T>
Eigen::ArrayXXd squared_distances(const RowArray<T>& z) {
  Eigen::ArrayXXd distances = Eigen::ArrayXXd::Zero(z.rows(), z.rows());
  for (Index i = 0; i < z.rows(); ++i) {
    for (Index j = 0; j < i; ++j) {
      distances(i, j) = static_cast<double>((z.row(i) - z.row(j)).square().sum());
      distances(j, i) = distances(i, j);
    }
  }
  return distances;
}

template <class T>
double mean_square(const RowArray<T>& difference) {
  return static_cast<double>(difference.square().mean());
}

template <class T>
RowArray<T> mean_square_gradient(const RowArray<T>& difference) {
  return difference * static_cast<T>(2.0 / static_cast<double>(difference.size()));
}

template <class T>
RowArray<T> inner(const RowArray<T>& samples, Index from) {
  return samples.middleCols(from, samples.cols() - 2);
}

/// The contact force in N at a compression in m, and its derivative in N/m.
struct Contact {
  double force;
  double stiffness;
};

Contact contact_at(double compression, const Physics& physics) {
  if (compression <= 0) return {0, 0};
  const double root = std::sqrt(compression);
  return {physics.contact_n_per_m15 * compression * root, 1.5 * physics.contact_n_per_m15 * root};
}

/// The compression of the contact at static equilibrium, in m, and its derivative by k~.
struct Rest {
  double compression;
  double by_k;
};

Rest rest_at(double k, double deflection, const Physics& physics) {
  const double stiffness = k * stiffness_scale_n_per_m;
  const double s = static_equilibrium_m(stiffness, deflection, physics);
  const double slope = stiffness + contact_at(s - deflection, physics).stiffness;
  return {s - deflection, -s / slope * stiffness_scale_n_per_m};
}

}  // namespace

template <class T>
double add_batch_mmd(const RowArray<T>& x, const RowArray<T>& y, RowArray<T>* by_x,
                     RowArray<T>& by_y) {
  const Index n = x.rows();
  const Index m = y.rows();
  RowArray<T> z(n + m, x.cols());
  z << x, y;
  const Eigen::ArrayXXd distances = squared_distances(z);
  const auto pairs = static_cast<double>((n + m) * (n + m - 1));
  const double mean = distances.sum() / pairs / 4;
  const double bandwidth = std::max(mean, mmd_least_bandwidth);

  Eigen::ArrayXXd weights(n + m, n + m);
  weights.topLeftCorner(n, n) = 1.0 / static_cast<double>(n * n);
  weights.bottomRightCorner(m, m) = 1.0 / static_cast<double>(m * m);
  weights.topRightCorner(n, m) = -1.0 / static_cast<double>(n * m);
  weights.bottomLeftCorner(m, n) = -1.0 / static_cast<double>(n * m);

  double value = 0;
  double by_bandwidth = 0;
  Eigen::ArrayXXd by_distance = Eigen::ArrayXXd::Zero(n + m, n + m);
  for (const double factor : mmd_kernel_factors) {
    const double width = bandwidth * factor;
    const Eigen::ArrayXXd kernel = weights * (-distances / width).exp();
    value += kernel.sum();
    by_distance -= kernel / width;
    by_bandwidth += (kernel * distances).sum() / (width * bandwidth);
  }
  if (mean > mmd_least_bandwidth) by_distance += by_bandwidth / (4 * pairs);

  // The distance of z_i and z_j stands in the matrix twice, at (i, j) and at (j, i), and its
  // derivative has a factor of 2: hence 4.
  const Eigen::ArrayXXd pull = 4 * by_distance;
  const Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> mixing =
      (Eigen::MatrixXd(pull.rowwise().sum().matrix().asDiagonal()) - pull.matrix())
          .template cast<T>();
  if (by_x) *by_x += (mixing.topRows(n) * z.matrix()).array();
  by_y += (mixing.bottomRows(m) * z.matrix()).array();
  return value;
}

template <class T>
LossOf<T> reconstruction_loss(const RowArray<T>& x, const RowArray<T>& a) {
  LossOf<T> loss;
  const RowArray<T> error = a - x;
  loss.by_acceleration = mean_square_gradient<T>(error);
  loss.value = mean_square<T>(error) + add_batch_mmd<T>(x, a, nullptr, loss.by_acceleration);
  return loss;
}

template <class T>
LossOf<T> differential_loss(const BatchMotion<T>& motion, double step) {
  const RowArray<T>& u = motion.displacement;
  const RowArray<T>& v = motion.velocity;
  const Index samples = u.cols();
  const Index inside = samples - 2;
  const auto per_square = static_cast<T>(1 / (step * step));
  const auto per_step = static_cast<T>(1 / (2 * step));
  const RowArray<T> a = inner(motion.acceleration, 1);
  const RowArray<T> second = (inner(u, 2) - 2 * inner(u, 1) + inner(u, 0)) * per_square;
  const RowArray<T> first = (inner(v, 2) - inner(v, 0)) * per_step;

  LossOf<T> loss;
  RowArray<T> by_second = mean_square_gradient<T>(second - a);
  RowArray<T> by_first = mean_square_gradient<T>(first - a);
  RowArray<T> by_a = -by_second - by_first;
  loss.value = mean_square<T>(second - a) + mean_square<T>(first - a) +
               add_batch_mmd<T>(second, a, &by_second, by_a) +
               add_batch_mmd<T>(first, a, &by_first, by_a);

  loss.by_acceleration = RowArray<T>::Zero(u.rows(), samples);
  loss.by_acceleration.middleCols(1, inside) = by_a;
  loss.by_displacement = RowArray<T>::Zero(u.rows(), samples);
  by_second *= per_square;
  loss.by_displacement.middleCols(2, inside) += by_second;
  loss.by_displacement.middleCols(1, inside) -= 2 * by_second;
  loss.by_displacement.middleCols(0, inside) += by_second;
  loss.by_velocity = RowArray<T>::Zero(u.rows(), samples);
  by_first *= per_step;
  loss.by_velocity.middleCols(2, inside) += by_first;
  loss.by_velocity.middleCols(0, inside) -= by_first;
  return loss;
}

template <class T>
LossOf<T> twin_loss(const RowArray<T>& k_and_c, const BatchMotion<T>& motion,
                    std::span<const Label> labels, const Physics& physics) {
  const auto& [u, v, a] = motion;
  LossOf<T> loss;
  loss.by_acceleration.resize(a.rows(), a.cols());
  loss.by_displacement.resize(a.rows(), a.cols());
  loss.by_velocity.resize(a.rows(), a.cols());
  loss.by_k_and_c.resize(a.rows(), 2);
  const double mean = 1.0 / static_cast<double>(a.size());
  for (Index i = 0; i < a.rows(); ++i) {
    const std::size_t label = index_of(labels[static_cast<std::size_t>(i)]);
    const double a_ref = physics.acceleration_m_s2[label];
    const double reference_n = physics.mass_kg * a_ref;
    const double reference_m = a_ref / (physics.omega_0 * physics.omega_0);
    const auto k = static_cast<double>(k_and_c(i, 0));
    const double damping = physics.damping * static_cast<double>(k_and_c(i, 1));
    const Rest rest = rest_at(k, physics.deflection_m[label], physics);
    const Contact at_rest = contact_at(rest.compression, physics);
    double by_k = 0;
    double by_damping = 0;
    for (Index t = 0; t < a.cols(); ++t) {
      const double displacement = u(i, t);
      const Contact contact = contact_at(rest.compression + displacement * reference_m, physics);
      const double residual = a(i, t) + damping * v(i, t) + k * displacement +
                              (contact.force - at_rest.force) / reference_n;
      const double slope = 2 * mean * residual;
      loss.value += mean * residual * residual;
      loss.by_acceleration(i, t) = static_cast<T>(slope);
      loss.by_velocity(i, t) = static_cast<T>(slope * damping);
      loss.by_displacement(i, t) =
          static_cast<T>(slope * (k + contact.stiffness * reference_m / reference_n));
      by_k += slope *
              (displacement + (contact.stiffness - at_rest.stiffness) * rest.by_k / reference_n);
      by_damping += slope * v(i, t);
    }
    loss.by_k_and_c(i, 0) = static_cast<T>(by_k);
    loss.by_k_and_c(i, 1) = static_cast<T>(by_damping * physics.damping);
  }
  return loss;
}

#define PIAE_INSTANTIATE(T)                                                                       \
  template double add_batch_mmd(const RowArray<T>&, const RowArray<T>&, RowArray<T>*,             \
                                RowArray<T>&);                                                    \
  template LossOf<T> reconstruction_loss(const RowArray<T>&, const RowArray<T>&);                 \
  template LossOf<T> differential_loss(const BatchMotion<T>&, double);                            \
  template LossOf<T> twin_loss(const RowArray<T>&, const BatchMotion<T>&, std::span<const Label>, \
                               const Physics&)
PIAE_INSTANTIATE(float);
PIAE_INSTANTIATE(double);

}  // namespace piae::twin
