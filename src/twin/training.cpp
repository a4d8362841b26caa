#include "twin/training.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "nets/adam.hpp"
#include "nets/device.hpp"
#include "nets/torch.hpp"
#include "signal/amplitude.hpp"
#include "twin/curves.hpp"
#include "twin/inputs.hpp"
#include "twin/losses.hpp"
#include "twin/model.hpp"
#include "twin/scaling.hpp"
#include "twin/space.hpp"

namespace piae::twin {

namespace {

const std::string log_weights_name = "loss/log_weights";

std::vector<nets::ParameterSpec> all_specs(const Networks& networks) {
  std::vector<nets::ParameterSpec> specs = networks.specs();
  specs.push_back({log_weights_name, {3}});  // alpha = beta = gamma = 1 at the start
  return specs;
}

struct Losses {
  torch::Tensor reconstruction;
  torch::Tensor differential;
  torch::Tensor twin;
  torch::Tensor total;
};

/// Where there is no physics module.
Losses reconstruction_alone(const torch::Tensor& loss) {
  const torch::Tensor none = torch::zeros_like(loss);
  return {loss, none, none, loss};
}

/// Sums over the batches of an epoch.
struct EpochSums {
  double reconstruction = 0;
  double differential = 0;
  double twin = 0;
  double total = 0;
  int batches = 0;

  void add(const Losses& losses) {
    reconstruction += losses.reconstruction.item<double>();
    differential += losses.differential.item<double>();
    twin += losses.twin.item<double>();
    total += losses.total.item<double>();
    ++batches;
  }
};

class Training final : public TwinTraining {
 public:
  Training(const signal::WindowSet& known, const TwinOptions& options, const TwinVariant& variant,
           const Stream& stream, torch::Device device, const std::optional<KnownStates>& states)
      : options_(options),
        variant_(variant),
        stream_(stream),
        info_(known.info),
        scale_(signal::rms_by_class(known)),
        physics_(make_physics(known.info, scale_, options)),
        shape_{static_cast<std::int64_t>(known.length),
               static_cast<std::int64_t>(known.info.classes.size())},
        networks_(variant, shape_, options),
        windows_(scaled_windows(known, scale_).to(device)),
        labels_(torch::tensor(known.labels, torch::kInt64).to(device)),
        parameters_(all_specs(networks_), stream.child("initial"), torch::kFloat32, device),
        networks_adam_(parameters_.values("net/"), parameters_.gradients("net/")),
        weights_adam_(parameters_.values(log_weights_name),
                      parameters_.gradients(log_weights_name)),
        best_(parameters_.values().clone()) {
    if (!states) return;
    given_ = {as_tensor(states->points, device), as_tensor(states->decoder_inputs, device)};
  }

  [[nodiscard]] std::size_t epochs() const override {
    return static_cast<std::size_t>(options_.epochs);
  }

  std::string run_epoch(std::size_t epoch) override {
    Stream shuffle = stream_.child("epoch" + std::to_string(epoch));
    const std::vector<std::size_t> order =
        shuffle.permutation(static_cast<std::size_t>(labels_.size(0)));
    const torch::Tensor rows =
        torch::tensor(std::vector<std::int64_t>(order.begin(), order.end()), labels_.options());
    const bool stage_1 = epoch / static_cast<std::size_t>(options_.stage_epochs) % 2 == 0;
    const double learning_rate = learning_rate_at(epoch);
    EpochSums sums;
    for (const torch::Tensor& batch : rows.split(options_.batch)) {
      sums.add(stage_1 ? step_stage_1(batch, learning_rate) : step_stage_2(batch, learning_rate));
    }
    note_epoch(epoch, sums, learning_rate);
    return fmt::format("L_Rec {:.3f}  L_DDL {:.3f}  L_DT {:.3f}", curves_.reconstruction.back(),
                       curves_.differential.back(), curves_.twin.back());
  }

  void write_state(artefact::Writer& writer) const override {
    parameters_.write(writer, "/weights", parameters_.values());
    networks_adam_.write(writer, "/adam/networks");
    weights_adam_.write(writer, "/adam/loss_weights");
    writer.numbers("/best", nets::to_vector(best_));
    writer.attribute("/", "best_loss", best_loss_);
    writer.attribute("/", "best_epoch", best_epoch_);
    curves_.write(writer);
  }

  void read_state(const artefact::Reader& reader) override {
    parameters_.read(reader, "/weights");
    networks_adam_.read(reader, "/adam/networks");
    weights_adam_.read(reader, "/adam/loss_weights");
    const auto size = static_cast<std::size_t>(best_.numel());
    nets::copy_into(best_, reader.numbers<float>("/best", {size}).values);
    best_loss_ = reader.real("/", "best_loss");
    best_epoch_ = reader.integer("/", "best_epoch");
    curves_.read(reader);
  }

  void write_model(artefact::Writer& writer) override {
    const torch::NoGradGuard no_grad;
    write(writer, ModelDescription{info_, shape_, options_, scale_});
    parameters_.write(writer, "/final", parameters_.values());
    parameters_.write(writer, "/best", best_);
    if (options_.keep == "best") parameters_.values().copy_(best_);
    write_twin_space(writer);
    networks_adam_.write(writer, "/adam/networks");
    weights_adam_.write(writer, "/adam/loss_weights");
    writer.attribute("/", "best_epoch", best_epoch_);
    curves_.write(writer);
  }

 private:
  [[nodiscard]] double learning_rate_at(std::size_t epoch) const {
    const std::size_t decays = epoch / static_cast<std::size_t>(options_.decay_every);
    return options_.learning_rate * std::pow(options_.decay, static_cast<double>(decays));
  }

  /// (k~, c~), and what the decoder is given of them, as [n, 2] each.
  struct States {
    torch::Tensor k_and_c;
    torch::Tensor decoder_input;
  };

  [[nodiscard]] States states_of(const torch::Tensor& batch, const torch::Tensor& x) const {
    if (variant_.encoder) {
      const torch::Tensor encoded = networks_.encode(parameters_, x);
      return {encoded, encoded};
    }
    return {given_.k_and_c.index_select(0, batch), given_.decoder_input.index_select(0, batch)};
  }

  [[nodiscard]] Losses losses_of(const torch::Tensor& batch) const {
    const torch::Tensor x = windows_.index_select(0, batch);
    const torch::Tensor labels = labels_.index_select(0, batch);
    const torch::Tensor one_hot = torch::one_hot(labels, shape_.classes).to(x.options());
    const States states = states_of(batch, x);
    const torch::Tensor a = networks_.decode(parameters_, states.decoder_input, one_hot);
    if (!variant_.physics) return reconstruction_alone(reconstruction_loss(x, a));
    const Motion motion = networks_.move(parameters_, a);
    Losses losses;
    losses.reconstruction = reconstruction_loss(x, a);
    losses.differential = differential_loss(motion, a, physics_.step);
    losses.twin = twin_loss(states.k_and_c, a, motion, batch_physics(physics_, labels, x.options()),
                            physics_);
    losses.total = total_of(losses);
    return losses;
  }

  /// Eq. 23, or what --loss-weights makes of it.
  [[nodiscard]] torch::Tensor total_of(const Losses& losses) const {
    const bool fixed = options_.loss_weights == "fixed";
    const torch::Tensor& learned = parameters_[log_weights_name];
    return (options_.loss_weights == "adaptive" ? total_loss : weighted_loss)(
        losses.differential, losses.twin, losses.reconstruction,
        fixed ? learned.detach() : learned);
  }

  /// Eq. 24: the gradient of each network's own loss with respect to that network alone.
  Losses step_stage_1(const torch::Tensor& batch, double learning_rate) {
    Losses losses = losses_of(batch);
    const auto follow = [&](const std::string& network, const torch::Tensor& loss) {
      parameters_.set_gradients(network,
                                torch::autograd::grad({loss}, parameters_.with_prefix(network), {},
                                                      /*retain_graph=*/true));
      nets::clip_norm(parameters_.gradients(network), options_.max_gradient_norm);
    };
    follow("net/decoder/", losses.reconstruction);
    if (variant_.encoder) {
      follow("net/encoder/", variant_.physics ? losses.twin : losses.reconstruction);
    }
    if (variant_.physics) follow("net/physics/", losses.differential);
    networks_adam_.step(learning_rate);
    return losses;
  }

  /// Eq. 25: all networks and the weights of the losses together. Weights that are not learned have
  /// no gradient, and Adam leaves them as they are.
  Losses step_stage_2(const torch::Tensor& batch, double learning_rate) {
    parameters_.zero_gradients();
    Losses losses = losses_of(batch);
    losses.total.backward();
    nets::clip_norm(parameters_.gradients(), options_.max_gradient_norm);
    networks_adam_.step(learning_rate);
    weights_adam_.step(learning_rate);
    return losses;
  }

  void note_epoch(std::size_t epoch, const EpochSums& sums, double learning_rate) {
    const double n = sums.batches;
    curves_.reconstruction.push_back(sums.reconstruction / n);
    curves_.differential.push_back(sums.differential / n);
    curves_.twin.push_back(sums.twin / n);
    curves_.total.push_back(sums.total / n);
    curves_.learning_rate.push_back(learning_rate);
    const std::vector<float> log_weights = nets::to_vector(parameters_[log_weights_name]);
    curves_.alpha.push_back(std::exp(log_weights[0]));
    curves_.beta.push_back(std::exp(log_weights[1]));
    curves_.gamma.push_back(std::exp(log_weights[2]));
    // The weights move, so totals of two epochs do not compare; the plain sum of the losses does.
    const double loss = (sums.reconstruction + sums.differential + sums.twin) / n;
    if (!std::isfinite(loss)) {
      throw Error(Exit::failed, "training diverged in epoch " + std::to_string(epoch + 1) +
                                    "; a smaller --learning-rate may help");
    }
    if (loss < best_loss_) {
      best_loss_ = loss;
      best_epoch_ = static_cast<std::int64_t>(epoch) + 1;
      best_.copy_(parameters_.values());
    }
  }

  /// Eqs 14 and 15, with the networks as they stand.
  void write_twin_space(artefact::Writer& writer) const {
    const std::vector<float> flat = nets::to_vector(
        variant_.encoder ? networks_.encode(parameters_, windows_) : given_.k_and_c);
    std::vector<TwinPoint> points;
    for (std::size_t i = 0; i < flat.size(); i += 2) points.push_back({flat[i], flat[i + 1]});
    TwinSpace(points, options_.space_bins).write(writer);
  }

  TwinOptions options_;
  TwinVariant variant_;
  Stream stream_;
  signal::DatasetInfo info_;
  std::vector<double> scale_;
  Physics physics_;
  NetworkShape shape_;
  Networks networks_;
  torch::Tensor windows_;
  torch::Tensor labels_;
  States given_;  // of all known windows, where there is no encoder
  nets::ParameterSet parameters_;
  nets::Adam networks_adam_;
  nets::Adam weights_adam_;
  torch::Tensor best_;
  double best_loss_ = std::numeric_limits<double>::infinity();
  std::int64_t best_epoch_ = 0;
  Curves curves_;
};

}  // namespace

std::unique_ptr<TwinTraining> make_twin_training(const signal::WindowSet& known,
                                                 const TwinOptions& options,
                                                 const TwinVariant& variant, const Stream& stream,
                                                 const std::string& device,
                                                 const std::optional<KnownStates>& states) {
  return std::make_unique<Training>(known, options, variant, stream, nets::prepare_device(device),
                                    states);
}

}  // namespace piae::twin
