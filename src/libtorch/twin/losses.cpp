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

/// Averages values [batch, samples] over the batch. Over the samples, sums or averages them,
/// depending on `squares`.
torch::Tensor averaged(const torch::Tensor& small, twin::Squares squares) {
  const torch::Tensor mean = small.mean();
  return squares == twin::Squares::sum ? mean * static_cast<double>(small.size(1)) : mean;
}

torch::Tensor squares_of(const torch::Tensor& error, twin::Squares squares) {
  return averaged(error.square(), squares);
}

torch::Tensor mmd_of(const torch::Tensor& x, const torch::Tensor& y, twin::Mmd mmd) {
  const torch::Tensor squared = batch_mmd(x, y);
  return mmd == twin::Mmd::squared ? squared : squared.clamp_min(twin::mmd_least_squared).sqrt();
}

/// Returns the derivative of signals [batch, N] at the samples that the taps reach, [batch, N - 2
/// reach]. Does not use a convolution, because oneDNN 3.7 computes a wrong gradient for one
/// channel.
torch::Tensor derivative(const torch::Tensor& signals, const std::vector<double>& taps,
                         double per_tap) {
  const torch::Tensor kernel = torch::tensor(taps, torch::kFloat64).to(signals.options());
  return signals.unfold(1, std::ssize(taps), 1).matmul(kernel) * per_tap;
}

/// Returns the contact force in N at a displacement s in m (twin/contact.hpp).
torch::Tensor contact_force(const torch::Tensor& s, const torch::Tensor& w,
                            const BatchPhysics& batch, const twin::Physics& physics) {
  const auto power = [&](const torch::Tensor& delta) { return (s - delta).clamp_min(0).pow(1.5); };
  return physics.contact_n_per_m15 * ((1 - w) * power(batch.outside) + w * power(batch.inside));
}

/// Returns the numbers of a tensor [batch, 1].
std::vector<double> numbers_of(const torch::Tensor& column) {
  const torch::Tensor flat = column.detach().to(torch::kCPU, torch::kFloat64).contiguous();
  return {flat.data_ptr<double>(), flat.data_ptr<double>() + flat.numel()};
}

/// Returns the static equilibrium s_0 [batch, 1] in m. Newton's method finds its value without
/// autograd. One further step, with a slope that is constant for autograd, gives the exact
/// derivative ds_0/dk = -s_0 / slope.
torch::Tensor static_equilibrium(const torch::Tensor& stiffness, const BatchPhysics& batch,
                                 const twin::Physics& physics) {
  const std::vector<double> k = numbers_of(stiffness);
  const std::vector<double> outside = numbers_of(batch.outside);
  const std::vector<double> inside = numbers_of(batch.inside);
  const std::vector<double> at_rest = numbers_of(batch.at_rest);
  std::vector<double> root;
  for (std::size_t i = 0; i < k.size(); ++i) {
    const twin::Contact contact{
        .outside_m = outside[i], .inside_m = inside[i], .at_rest = at_rest[i]};
    root.push_back(twin::static_equilibrium_m(k[i], contact, physics));
  }
  const torch::Tensor s = torch::tensor(root, torch::kFloat64)
                              .view({-1, 1})
                              .to(stiffness.options().requires_grad(false));
  const auto part = [&](const torch::Tensor& delta) { return (s - delta).clamp_min(0).sqrt(); };
  const torch::Tensor slope = stiffness.detach() + 1.5 * physics.contact_n_per_m15 *
                                                       ((1 - batch.at_rest) * part(batch.outside) +
                                                        batch.at_rest * part(batch.inside));
  return s - (stiffness - stiffness.detach()) * s / slope;
}

/// Returns the w of every sample: [batch, N] if a class gives it sample by sample, otherwise like
/// `at_rest`.
torch::Tensor passing_of(const twin::Physics& physics, const torch::Tensor& labels,
                         const torch::Tensor& at_rest) {
  std::size_t samples = 0;
  for (const twin::Contact& contact : physics.contact) {
    samples = std::max(samples, contact.passing.size());
  }
  if (samples == 0) return at_rest;
  std::vector<torch::Tensor> rows;
  for (const twin::Contact& contact : physics.contact) {
    rows.push_back(torch::tensor(
        contact.passing.empty() ? std::vector<double>(samples, contact.at_rest) : contact.passing,
        torch::kFloat64));
  }
  return torch::stack(rows).to(at_rest.options()).index_select(0, labels);
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

torch::Tensor reconstruction_loss(const torch::Tensor& x, const torch::Tensor& a,
                                  const twin::LossInterpretation& interpretation) {
  return squares_of(x - a, interpretation.squares) + mmd_of(x, a, interpretation.mmd);
}

torch::Tensor differential_loss(const Motion& motion, const torch::Tensor& a, double step,
                                const twin::Stencil& stencil,
                                const twin::LossInterpretation& interpretation) {
  const torch::Tensor inner = a.narrow(1, stencil.reach, a.size(1) - 2 * stencil.reach);
  const torch::Tensor second = derivative(motion.displacement, stencil.second, 1 / (step * step));
  const torch::Tensor first = derivative(motion.velocity, stencil.first, 1 / step);
  return squares_of(second - inner, interpretation.squares) +
         squares_of(first - inner, interpretation.squares) +
         mmd_of(second, inner, interpretation.mmd) + mmd_of(first, inner, interpretation.mmd);
}

BatchPhysics batch_physics(const twin::Physics& physics, const torch::Tensor& labels,
                           const torch::TensorOptions& type) {
  const auto per_window = [&](const auto& of_class) {
    std::vector<double> per_class;
    for (std::size_t label = 0; label < physics.contact.size(); ++label) {
      per_class.push_back(of_class(label));
    }
    return torch::tensor(per_class, torch::kFloat64).to(type).index_select(0, labels).unsqueeze(1);
  };
  const auto& contacts = physics.contact;
  const torch::Tensor a_ref =
      per_window([&](std::size_t label) { return physics.acceleration_m_s2[label]; });
  const torch::Tensor at_rest =
      per_window([&](std::size_t label) { return contacts[label].at_rest; });
  return {.outside = per_window([&](std::size_t label) { return contacts[label].outside_m; }),
          .inside = per_window([&](std::size_t label) { return contacts[label].inside_m; }),
          .at_rest = at_rest,
          .passing = passing_of(physics, labels, at_rest),
          .displacement = a_ref / (physics.omega_0 * physics.omega_0),
          .force = physics.mass_kg * a_ref};
}

torch::Tensor twin_loss(const torch::Tensor& k_and_c, const torch::Tensor& a, const Motion& motion,
                        const BatchPhysics& batch, const twin::Physics& physics,
                        const twin::LossInterpretation& interpretation) {
  const torch::Tensor k = k_and_c.narrow(1, 0, 1);
  const torch::Tensor c = k_and_c.narrow(1, 1, 1);
  const torch::Tensor s_0 = static_equilibrium(k * twin::stiffness_scale_n_per_m, batch, physics);
  const torch::Tensor s = s_0 + motion.displacement * batch.displacement;
  const torch::Tensor contact = (contact_force(s, batch.passing, batch, physics) -
                                 contact_force(s_0, batch.at_rest, batch, physics)) /
                                batch.force;
  const torch::Tensor residual =
      a + physics.damping * c * motion.velocity + k * motion.displacement + contact;
  return averaged(
      interpretation.residual == twin::Residual::squared ? residual.square() : residual.abs(),
      interpretation.squares);
}

}  // namespace piae::libtorch
