#include "libtorch/twin/losses.hpp"

#include <span>
#include <vector>

#include "libtorch/nets/torch.hpp"
#include "twin/losses.hpp"

namespace piae::libtorch {

namespace {

torch::Tensor squared_distances(const torch::Tensor& rows) {
  const torch::Tensor products = torch::mm(rows, rows.t());
  const torch::Tensor squares = products.diagonal();
  return (squares.unsqueeze(0) + squares.unsqueeze(1) - 2 * products).clamp_min(0);
}

torch::Tensor mean_square(const torch::Tensor& x) { return x.square().mean(); }

/// The contact force in N at a compression s - delta in m.
torch::Tensor contact_force(const torch::Tensor& compression, const twin::Physics& physics) {
  return physics.contact_n_per_m15 * compression.clamp_min(0).pow(1.5);
}

/// The static equilibrium s_0 [batch, 1] in m. Newton's method finds its value without autograd.
/// One further step, with a slope that autograd takes for constant, then gives it the exact
/// derivative ds_0/dk = -s_0 / slope.
torch::Tensor static_equilibrium(const torch::Tensor& stiffness, const torch::Tensor& deflection,
                                 const twin::Physics& physics) {
  const torch::Tensor k = stiffness.detach().to(torch::kCPU, torch::kFloat64).contiguous();
  const torch::Tensor delta = deflection.to(torch::kCPU, torch::kFloat64).contiguous();
  torch::Tensor root = torch::empty_like(k);
  for (std::int64_t i = 0; i < k.numel(); ++i) {
    root.data_ptr<double>()[i] =
        twin::static_equilibrium_m(k.data_ptr<double>()[i], delta.data_ptr<double>()[i], physics);
  }
  const torch::Tensor s = root.to(stiffness.options().requires_grad(false));
  const torch::Tensor compression = (s - deflection).clamp_min(0);
  const torch::Tensor slope =
      stiffness.detach() + 1.5 * physics.contact_n_per_m15 * compression.sqrt();
  return s - (stiffness - stiffness.detach()) * s / slope;
}

}  // namespace

torch::Tensor batch_mmd(const torch::Tensor& x, const torch::Tensor& y) {
  const std::int64_t n = x.size(0);
  const std::int64_t m = y.size(0);
  const torch::Tensor distances = squared_distances(torch::cat({x, y}));
  const auto pairs = static_cast<double>((n + m) * (n + m - 1));
  const torch::Tensor bandwidth =
      (distances.sum() / pairs / 4).clamp_min(twin::mmd_least_bandwidth);
  static_assert(twin::mmd_kernel_factors.front() == 1);
  torch::Tensor kernel = torch::exp(-distances / bandwidth);
  for (const double factor : std::span(twin::mmd_kernel_factors).subspan(1)) {
    kernel = kernel + torch::exp(-distances / (bandwidth * factor));
  }
  return kernel.narrow(0, 0, n).narrow(1, 0, n).mean() +
         kernel.narrow(0, n, m).narrow(1, n, m).mean() -
         2 * kernel.narrow(0, 0, n).narrow(1, n, m).mean();
}

torch::Tensor reconstruction_loss(const torch::Tensor& x, const torch::Tensor& a) {
  return mean_square(x - a) + batch_mmd(x, a);
}

torch::Tensor differential_loss(const Motion& motion, const torch::Tensor& a, double step) {
  const std::int64_t inner = a.size(1) - 2;
  const torch::Tensor& u = motion.displacement;
  const torch::Tensor& v = motion.velocity;
  const torch::Tensor a_inner = a.narrow(1, 1, inner);
  const torch::Tensor second =
      (u.narrow(1, 2, inner) - 2 * u.narrow(1, 1, inner) + u.narrow(1, 0, inner)) / (step * step);
  const torch::Tensor first = (v.narrow(1, 2, inner) - v.narrow(1, 0, inner)) / (2 * step);
  return mean_square(second - a_inner) + mean_square(first - a_inner) + batch_mmd(second, a_inner) +
         batch_mmd(first, a_inner);
}

BatchPhysics batch_physics(const twin::Physics& physics, const torch::Tensor& labels,
                           const torch::TensorOptions& type) {
  const auto per_window = [&](const std::vector<double>& per_class) {
    return torch::tensor(per_class, torch::kFloat64).to(type).index_select(0, labels).unsqueeze(1);
  };
  const torch::Tensor a_ref = per_window(physics.acceleration_m_s2);
  return {.deflection = per_window(physics.deflection_m),
          .displacement = a_ref / (physics.omega_0 * physics.omega_0),
          .force = physics.mass_kg * a_ref};
}

torch::Tensor twin_loss(const torch::Tensor& k_and_c, const torch::Tensor& a, const Motion& motion,
                        const BatchPhysics& batch, const twin::Physics& physics) {
  const torch::Tensor k = k_and_c.narrow(1, 0, 1);
  const torch::Tensor c = k_and_c.narrow(1, 1, 1);
  const torch::Tensor s_0 =
      static_equilibrium(k * twin::stiffness_scale_n_per_m, batch.deflection, physics);
  const torch::Tensor compression = s_0 - batch.deflection;
  const torch::Tensor contact =
      (contact_force(compression + motion.displacement * batch.displacement, physics) -
       contact_force(compression, physics)) /
      batch.force;
  return mean_square(a + physics.damping * c * motion.velocity + k * motion.displacement + contact);
}

torch::Tensor weighted_loss(const torch::Tensor& differential, const torch::Tensor& twin,
                            const torch::Tensor& reconstruction, const torch::Tensor& log_weights) {
  const torch::Tensor losses = torch::stack({differential, twin, reconstruction});
  return (log_weights.exp() * losses).sum();
}

torch::Tensor total_loss(const torch::Tensor& differential, const torch::Tensor& twin,
                         const torch::Tensor& reconstruction, const torch::Tensor& log_weights) {
  return weighted_loss(differential, twin, reconstruction, log_weights) - 0.5 * log_weights.sum();
}

}  // namespace piae::libtorch
