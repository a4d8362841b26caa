#include "twin/losses.hpp"

#include <algorithm>
#include <cmath>

namespace piae::twin {

namespace {

using Eigen::Index;

/// Returns the squared distances of all pairs of rows of z, [n, n].
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

/// Adds the squares of an error [batch, samples] to a loss and returns the gradient by the error.
template <class T>
RowArray<T> add_squares(const RowArray<T>& error, Squares squares, double& loss) {
  const double per_window = squares == Squares::sum ? static_cast<double>(error.cols()) : 1;
  loss += per_window * static_cast<double>(error.square().mean());
  return error * static_cast<T>(per_window * 2.0 / static_cast<double>(error.size()));
}

/// Adds the MMD of two batches, by the interpretation `mmd`, to a loss, and its gradients to by_x
/// and by_y.
template <class T>
void add_mmd(const RowArray<T>& x, const RowArray<T>& y, RowArray<T>* by_x, RowArray<T>& by_y,
             Mmd mmd, double& loss) {
  if (mmd == Mmd::squared) {
    loss += add_batch_mmd<T>(x, y, by_x, by_y);
    return;
  }
  RowArray<T> squared_by_x = RowArray<T>::Zero(x.rows(), x.cols());
  RowArray<T> squared_by_y = RowArray<T>::Zero(y.rows(), y.cols());
  const double squared = add_batch_mmd<T>(x, y, by_x ? &squared_by_x : nullptr, squared_by_y);
  const double root = std::sqrt(std::max(squared, mmd_least_squared));
  loss += root;
  if (squared <= mmd_least_squared) return;
  const auto slope = static_cast<T>(1 / (2 * root));
  if (by_x) *by_x += slope * squared_by_x;
  by_y += slope * squared_by_y;
}

/// Returns the derivative of signals [batch, N] at the samples that the taps reach, [batch, N - 2
/// reach].
template <class T>
RowArray<T> derivative(const RowArray<T>& signals, const std::vector<double>& taps,
                       double per_tap) {
  const auto last = static_cast<Index>(taps.size()) - 1;
  RowArray<T> sum = RowArray<T>::Zero(signals.rows(), signals.cols() - last);
  for (Index i = last; i >= 0; --i) {
    const auto tap = static_cast<T>(taps[static_cast<std::size_t>(i)]);
    if (tap != 0) sum += tap * signals.middleCols(i, sum.cols());
  }
  return sum * static_cast<T>(per_tap);
}

/// Returns the gradient by the signals [batch, N] from the gradient by the output of derivative().
template <class T>
RowArray<T> by_signals(RowArray<T> by_derivative, const std::vector<double>& taps, double per_tap) {
  const auto last = static_cast<Index>(taps.size()) - 1;
  RowArray<T> sum = RowArray<T>::Zero(by_derivative.rows(), by_derivative.cols() + last);
  by_derivative *= static_cast<T>(per_tap);
  for (Index i = last; i >= 0; --i) {
    const auto tap = static_cast<T>(taps[static_cast<std::size_t>(i)]);
    if (tap != 0) sum.middleCols(i, by_derivative.cols()) += tap * by_derivative;
  }
  return sum;
}

/// The static equilibrium minus the delta outside and inside the defect, in m; the force there; the
/// derivative of the equilibrium by k~.
struct Rest {
  double outside_m = 0;
  double inside_m = 0;
  ContactForce force{};
  double by_k = 0;
};

Rest rest_at(double k, const Contact& contact, const Physics& physics) {
  const double stiffness = k * stiffness_scale_n_per_m;
  const double s = static_equilibrium_m(stiffness, contact, physics);
  Rest rest{.outside_m = s - contact.outside_m, .inside_m = s - contact.inside_m};
  rest.force =
      contact_force(rest.outside_m, rest.inside_m, contact.at_rest, physics.contact_n_per_m15);
  const double slope = stiffness + rest.force.stiffness_n_per_m;
  rest.by_k = -s / slope * stiffness_scale_n_per_m;
  return rest;
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

  // The matrix contains the distance of z_i and z_j twice, at (i, j) and (j, i), and its derivative
  // has a factor of 2: hence 4.
  const Eigen::ArrayXXd pull = 4 * by_distance;
  const Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> mixing =
      (Eigen::MatrixXd(pull.rowwise().sum().matrix().asDiagonal()) - pull.matrix())
          .template cast<T>();
  if (by_x) *by_x += (mixing.topRows(n) * z.matrix()).array();
  by_y += (mixing.bottomRows(m) * z.matrix()).array();
  return value;
}

template <class T>
LossOf<T> reconstruction_loss(const RowArray<T>& x, const RowArray<T>& a,
                              const LossInterpretation& interpretation) {
  LossOf<T> loss;
  loss.by_acceleration = add_squares<T>(a - x, interpretation.squares, loss.value);
  add_mmd<T>(x, a, nullptr, loss.by_acceleration, interpretation.mmd, loss.value);
  return loss;
}

template <class T>
LossOf<T> differential_loss(const BatchMotion<T>& motion, double step, const Stencil& stencil,
                            const LossInterpretation& interpretation) {
  const RowArray<T>& u = motion.displacement;
  const RowArray<T>& v = motion.velocity;
  const Index samples = u.cols();
  const Index inside = samples - 2 * stencil.reach;
  const double per_square = 1 / (step * step);
  const double per_step = 1 / step;
  const RowArray<T> a = motion.acceleration.middleCols(stencil.reach, inside);
  const RowArray<T> second = derivative<T>(u, stencil.second, per_square);
  const RowArray<T> first = derivative<T>(v, stencil.first, per_step);

  LossOf<T> loss;
  RowArray<T> by_second = add_squares<T>(second - a, interpretation.squares, loss.value);
  RowArray<T> by_first = add_squares<T>(first - a, interpretation.squares, loss.value);
  RowArray<T> by_a = -by_second - by_first;
  add_mmd<T>(second, a, &by_second, by_a, interpretation.mmd, loss.value);
  add_mmd<T>(first, a, &by_first, by_a, interpretation.mmd, loss.value);

  loss.by_acceleration = RowArray<T>::Zero(u.rows(), samples);
  loss.by_acceleration.middleCols(stencil.reach, inside) = by_a;
  loss.by_displacement = by_signals<T>(by_second, stencil.second, per_square);
  loss.by_velocity = by_signals<T>(by_first, stencil.first, per_step);
  return loss;
}

template <class T>
LossOf<T> twin_loss(const RowArray<T>& k_and_c, const BatchMotion<T>& motion,
                    std::span<const Label> labels, const Physics& physics,
                    const LossInterpretation& interpretation) {
  const auto& [u, v, a] = motion;
  LossOf<T> loss;
  loss.by_acceleration.resize(a.rows(), a.cols());
  loss.by_displacement.resize(a.rows(), a.cols());
  loss.by_velocity.resize(a.rows(), a.cols());
  loss.by_k_and_c.resize(a.rows(), 2);
  const auto counted = interpretation.squares == Squares::sum ? a.rows() : a.size();
  const double mean = 1.0 / static_cast<double>(counted);
  const bool squared = interpretation.residual == Residual::squared;
  for (Index i = 0; i < a.rows(); ++i) {
    const std::size_t label = index_of(labels[static_cast<std::size_t>(i)]);
    const Contact& contact = physics.contact[label];
    const double a_ref = physics.acceleration_m_s2[label];
    const double reference_n = physics.mass_kg * a_ref;
    const double reference_m = a_ref / (physics.omega_0 * physics.omega_0);
    const auto k = static_cast<double>(k_and_c(i, 0));
    const double damping = physics.damping * static_cast<double>(k_and_c(i, 1));
    const Rest rest = rest_at(k, contact, physics);
    double by_k = 0;
    double by_damping = 0;
    for (Index t = 0; t < a.cols(); ++t) {
      const double displacement = u(i, t);
      const double moved_m = displacement * reference_m;
      const double w =
          contact.passing.empty() ? contact.at_rest : contact.passing[static_cast<std::size_t>(t)];
      const ContactForce force = contact_force(rest.outside_m + moved_m, rest.inside_m + moved_m, w,
                                               physics.contact_n_per_m15);
      const double residual = a(i, t) + damping * v(i, t) + k * displacement +
                              (force.force_n - rest.force.force_n) / reference_n;
      const double slope =
          squared ? 2 * mean * residual : std::copysign(residual == 0 ? 0 : mean, residual);
      loss.value += squared ? mean * residual * residual : mean * std::abs(residual);
      loss.by_acceleration(i, t) = static_cast<T>(slope);
      loss.by_velocity(i, t) = static_cast<T>(slope * damping);
      loss.by_displacement(i, t) =
          static_cast<T>(slope * (k + force.stiffness_n_per_m * reference_m / reference_n));
      by_k += slope * (displacement + (force.stiffness_n_per_m - rest.force.stiffness_n_per_m) *
                                          rest.by_k / reference_n);
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
  template LossOf<T> reconstruction_loss(const RowArray<T>&, const RowArray<T>&,                  \
                                         const LossInterpretation&);                              \
  template LossOf<T> differential_loss(const BatchMotion<T>&, double, const Stencil&,             \
                                       const LossInterpretation&);                                \
  template LossOf<T> twin_loss(const RowArray<T>&, const BatchMotion<T>&, std::span<const Label>, \
                               const Physics&, const LossInterpretation&)
PIAE_INSTANTIATE(float);
PIAE_INSTANTIATE(double);

}  // namespace piae::twin
