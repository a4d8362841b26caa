#include "libtorch/twin/backend.hpp"

#include <algorithm>
#include <utility>

#include "libtorch/nets/adam.hpp"
#include "libtorch/nets/device.hpp"
#include "libtorch/nets/torch.hpp"
#include "libtorch/twin/losses.hpp"
#include "libtorch/twin/model.hpp"
#include "libtorch/twin/networks.hpp"
#include "twin/losses.hpp"
#include "twin/specs.hpp"

namespace piae::libtorch {

namespace {

/// The losses of a batch, as tensors without dimensions.
struct Losses {
  torch::Tensor reconstruction;
  torch::Tensor differential;
  torch::Tensor twin;
  torch::Tensor total;

  [[nodiscard]] twin::BatchLosses values() const {
    return {.reconstruction = reconstruction.item<double>(),
            .differential = differential.item<double>(),
            .twin = twin.item<double>(),
            .total = total.item<double>()};
  }
};

/// Returns the losses of a variant without the physics-informed module.
Losses reconstruction_alone(const torch::Tensor& loss) {
  const torch::Tensor none = torch::zeros_like(loss);
  return {.reconstruction = loss, .differential = none, .twin = none, .total = loss};
}

class TwinOnTorch final : public twin::TwinBackend {
 public:
  TwinOnTorch(twin::TwinTask task, const Stream& initial, torch::Device device)
      : task_(std::move(task)),
        networks_(task_.variant, task_.shape, task_.options),
        stencil_(twin::stencil_of(task_.options.derivatives)),
        interpretation_{.squares = task_.options.squares,
                        .mmd = task_.options.mmd,
                        .residual = task_.options.residual},
        specs_(twin::with_log_weights(networks_.specs())),
        windows_(torch::tensor(task_.windows).view({-1, task_.shape.samples}).to(device)),
        labels_(torch::tensor(task_.labels, torch::kInt64).to(device)),
        parameters_(specs_, initial, torch::kFloat32, device),
        networks_adam_(parameters_.values("net/"), parameters_.gradients("net/")),
        weights_adam_(parameters_.values(twin::log_weights_name),
                      parameters_.gradients(twin::log_weights_name)) {
    if (!task_.states) return;
    given_ = {.k_and_c = as_tensor(task_.states->points, device),
              .decoder_input = as_tensor(task_.states->decoder_inputs, device)};
  }

  twin::BatchLosses step(twin::TrainingStage stage, std::span<const std::size_t> windows,
                         const twin::LearningRates& rates) override {
    const torch::Tensor batch =
        torch::tensor(std::vector<std::int64_t>(windows.begin(), windows.end()), labels_.options());
    return stage == twin::TrainingStage::one ? step_stage_1(batch, rates)
                                             : step_stage_2(batch, rates);
  }

  [[nodiscard]] const std::vector<nets::ParameterSpec>& specs() const override { return specs_; }

  void copy_values(std::span<float> to) const override {
    const std::vector<float> values = to_vector(parameters_.values());
    std::copy(values.begin(), values.end(), to.begin());
  }
  [[nodiscard]] std::array<float, 3> log_weights() const override {
    const std::vector<float> logs = to_vector(parameters_[twin::log_weights_name]);
    return {logs[0], logs[1], logs[2]};
  }

  void set_values(std::span<const float> values) override {
    copy_into(parameters_.values(), values);
  }

  [[nodiscard]] std::vector<twin::TwinPoint> states() override {
    if (task_.states) return task_.states->points;
    const torch::NoGradGuard no_grad;
    return as_points(networks_.encode(parameters_, windows_));
  }

  void write_adam(artefact::Writer& writer, const std::string& group) const override {
    networks_adam_.write(writer, group + "/networks");
    weights_adam_.write(writer, group + "/loss_weights");
  }

  void read_adam(const artefact::Reader& reader, const std::string& group) override {
    networks_adam_.read(reader, group + "/networks");
    weights_adam_.read(reader, group + "/loss_weights");
  }

 private:
  /// (k~, c~), and the decoder's two inputs for them, [n, 2] each.
  struct States {
    torch::Tensor k_and_c;
    torch::Tensor decoder_input;
  };

  [[nodiscard]] States states_of(const torch::Tensor& batch, const torch::Tensor& x) const {
    if (task_.variant.encoder) {
      const torch::Tensor encoded = networks_.encode(parameters_, x);
      return {.k_and_c = encoded, .decoder_input = encoded};
    }
    return {.k_and_c = given_.k_and_c.index_select(0, batch),
            .decoder_input = given_.decoder_input.index_select(0, batch)};
  }

  [[nodiscard]] Losses losses_of(const torch::Tensor& batch) const {
    const torch::Tensor x = windows_.index_select(0, batch);
    const torch::Tensor labels = labels_.index_select(0, batch);
    const torch::Tensor one_hot = torch::one_hot(labels, task_.shape.classes).to(x.options());
    const States states = states_of(batch, x);
    const torch::Tensor a = networks_.decode(parameters_, states.decoder_input, one_hot);
    if (!task_.variant.physics)
      return reconstruction_alone(reconstruction_loss(x, a, interpretation_));
    const Motion motion = networks_.move(parameters_, a);
    Losses losses;
    losses.reconstruction = reconstruction_loss(x, a, interpretation_);
    losses.differential =
        differential_loss(motion, a, task_.physics.step, stencil_, interpretation_);
    losses.twin =
        twin_loss(states.k_and_c, a, motion, batch_physics(task_.physics, labels, x.options()),
                  task_.physics, interpretation_);
    losses.total = total_of(losses);
    return losses;
  }

  /// Eq. 23, or its variant by LossWeights.
  [[nodiscard]] torch::Tensor total_of(const Losses& losses) const {
    const twin::LossWeights kind = task_.options.loss_weights;
    const torch::Tensor& learned = parameters_[twin::log_weights_name];
    const torch::Tensor weights = twin::are_learned(kind) ? learned : learned.detach();
    return twin::total_loss<torch::Tensor, torch::Tensor>(
        {losses.differential, losses.twin, losses.reconstruction},
        {weights[0], weights[1], weights[2]}, twin::have_logarithms(kind));
  }

  /// Eq. 24: each network follows the gradient of its own loss by its own parameters.
  twin::BatchLosses step_stage_1(const torch::Tensor& batch, const twin::LearningRates& rates) {
    const Losses losses = losses_of(batch);
    const auto follow = [&](const std::string& network, const torch::Tensor& loss) {
      parameters_.set_gradients(network,
                                torch::autograd::grad({loss}, parameters_.with_prefix(network), {},
                                                      /*retain_graph=*/true));
      clip_norm(parameters_.gradients(network), task_.options.max_gradient_norm);
    };
    follow(twin::decoder_name + "/", losses.reconstruction);
    if (task_.variant.encoder) {
      follow(twin::encoder_name + "/", task_.variant.physics ? losses.twin : losses.reconstruction);
    }
    if (task_.variant.physics) follow(twin::module_name + "/", losses.differential);
    networks_adam_.step(rates.networks);
    return losses.values();
  }

  /// Eq. 25: all networks and the loss weights follow the total. Weights that are not learned have
  /// a zero gradient, so Adam does not change them.
  twin::BatchLosses step_stage_2(const torch::Tensor& batch, const twin::LearningRates& rates) {
    parameters_.zero_gradients();
    const Losses losses = losses_of(batch);
    losses.total.backward();
    clip_norm(parameters_.gradients(), task_.options.max_gradient_norm);
    networks_adam_.step(rates.networks);
    weights_adam_.step(rates.loss_weights);
    return losses.values();
  }

  twin::TwinTask task_;
  Networks networks_;
  twin::Stencil stencil_;
  twin::LossInterpretation interpretation_;
  std::vector<nets::ParameterSpec> specs_;
  torch::Tensor windows_;  // all known windows, [n, N]
  torch::Tensor labels_;   // [n]
  States given_;           // states of all known windows, without an encoder
  ParameterSet parameters_;
  Adam networks_adam_;
  Adam weights_adam_;
};

}  // namespace

twin::Engine twin_engine(Device compute_device) {
  const torch::Device device = prepare_device(compute_device);
  return {.train =
              [device](twin::TwinTask task, const Stream& initial) {
                return std::make_unique<TwinOnTorch>(std::move(task), initial, device);
              },
          .open =
              [device](const artefact::Reader& model, const twin::ModelDescription& description,
                       const twin::TwinVariant& variant) {
                return open_model(model, description, variant, device);
              }};
}

}  // namespace piae::libtorch
