#include "twin/one_core_backend.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "base/label.hpp"
#include "twin/networks.hpp"
#include "twin/one_core_model.hpp"

namespace piae::twin {

namespace {

using Array = RowArray<float>;
using Network = nets::Network<float>;
using Parameters = nets::Parameters<float>;
using Kept = Parameters::Kept;

/// The known windows of a step, and the networks' outputs and losses for them.
struct Batch {
  Array windows;  ///< [batch, N]
  std::vector<Label> labels;
  Array k_and_c;  ///< [batch, 2]
  LossOf<float> reconstruction;
  LossOf<float> differential;
  LossOf<float> twin;

  [[nodiscard]] std::int64_t size() const { return windows.rows(); }
};

/// Returns the points of these windows.
std::vector<TwinPoint> chosen(const std::vector<TwinPoint>& points,
                              std::span<const std::size_t> windows) {
  std::vector<TwinPoint> chosen;
  for (const std::size_t i : windows) chosen.push_back(points[i]);
  return chosen;
}

/// Copies a gradient into a network's output gradient, starting at a row and a column.
void put(const Array& gradient, Network& network, std::int64_t row, std::int64_t column = 0) {
  nets::put(gradient, network.output_gradient().from(row), column);
}

/// Returns the rows of the last of several signals (nets::Network::backward).
nets::RowRange last_signal(std::int64_t rows, std::int64_t signals) {
  return {.begin = (signals - 1) * rows, .count = rows};
}

class OneCoreBackend final : public TwinBackend {
 public:
  OneCoreBackend(TwinTask task, const Stream& initial)
      : task_(std::move(task)),
        coder_(make_coder(task_.variant.coder, task_.shape, task_.options)),
        specs_(with_log_weights(
            network_specs(task_.variant, task_.shape, task_.options, coder_->specs()))),
        parameters_(std::make_shared<Parameters>(specs_, initial)),
        largest_batch_(std::min<std::int64_t>(task_.options.batch, std::ssize(task_.labels))),
        networks_(parameters_, task_.variant, *coder_, task_.shape, task_.options.positive,
                  largest_batch_),
        stencil_(stencil_of(task_.options.derivatives)),
        interpretation_{.squares = task_.options.squares,
                        .mmd = task_.options.mmd,
                        .residual = task_.options.residual},
        log_weights_(parameters_->find(log_weights_name).begin) {}

  BatchLosses step(TrainingStage stage, std::span<const std::size_t> windows,
                   const LearningRates& rates) override {
    const Batch batch = forward(windows);
    const nets::AdamStep adam(++steps_, rates.networks);
    const BatchLosses losses = losses_of(batch);
    if (stage == TrainingStage::one) {
      step_stage_1(batch, adam);
    } else {
      step_stage_2(batch, losses, adam, rates.loss_weights);
    }
    return losses;
  }

  [[nodiscard]] const std::vector<nets::ParameterSpec>& specs() const override { return specs_; }
  void copy_values(std::span<float> to) const override { parameters_->copy(Kept::value, to); }
  [[nodiscard]] std::array<float, 3> log_weights() const override {
    const float* const logs = parameters_->data(Kept::value) + log_weights_;
    return {logs[0], logs[1], logs[2]};
  }
  void set_values(std::span<const float> values) override {
    parameters_->write(Kept::value, values);
  }

  [[nodiscard]] std::vector<TwinPoint> states() override {
    return task_.states ? task_.states->points
                        : encode_all(networks_, task_.windows, largest_batch_);
  }

  void write_adam(artefact::Writer& writer, const std::string& group) const override {
    write_moments(writer, group + "/networks", *parameters_, "net/", steps_);
    write_moments(writer, group + "/loss_weights", *parameters_, log_weights_name, weight_steps_);
  }
  void read_adam(const artefact::Reader& reader, const std::string& group) override {
    steps_ = read_moments(reader, group + "/networks", *parameters_, "net/");
    weight_steps_ = read_moments(reader, group + "/loss_weights", *parameters_, log_weights_name);
  }

 private:
  Batch forward(std::span<const std::size_t> windows) {
    Batch batch;
    batch.windows = nets::gathered<float>(task_.windows, task_.shape.samples, windows);
    for (const std::size_t i : windows) batch.labels.push_back(task_.labels[i]);
    batch.k_and_c = task_.variant.encoder ? networks_.encode(batch.windows)
                                          : as_rows(chosen(task_.states->points, windows));
    const Array inputs = task_.variant.encoder
                             ? batch.k_and_c
                             : as_rows(chosen(task_.states->decoder_inputs, windows));
    const Array a = networks_.decode(inputs, batch.labels);
    batch.reconstruction = reconstruction_loss<float>(batch.windows, a, interpretation_);
    if (!task_.variant.physics) return batch;
    const BatchMotion<float> motion = networks_.move(a);
    batch.differential =
        differential_loss<float>(motion, task_.physics.step, stencil_, interpretation_);
    batch.twin =
        twin_loss<float>(batch.k_and_c, motion, batch.labels, task_.physics, interpretation_);
    return batch;
  }

  /// alpha, beta and gamma of eq. 23.
  struct Weights {
    float alpha;
    float beta;
    float gamma;
  };
  [[nodiscard]] Weights weights() const {
    if (!task_.variant.physics) return {.alpha = 0, .beta = 0, .gamma = 1};
    const auto [alpha, beta, gamma] = log_weights();
    return {.alpha = std::exp(alpha), .beta = std::exp(beta), .gamma = std::exp(gamma)};
  }

  static PerLoss<double> per_loss(const BatchLosses& losses) {
    return {losses.differential, losses.twin, losses.reconstruction};
  }

  [[nodiscard]] BatchLosses losses_of(const Batch& batch) const {
    BatchLosses losses{.reconstruction = batch.reconstruction.value,
                       .differential = batch.differential.value,
                       .twin = batch.twin.value};
    losses.total = task_.variant.physics ? total_loss(per_loss(losses), log_weights(),
                                                      have_logarithms(task_.options.loss_weights))
                                         : losses.reconstruction;
    return losses;
  }

  /// Eq. 24. The module follows L_DDL, the decoder L_Rec, and the encoder L_DT, which reaches it
  /// through the module and the decoder. So two signals go back through the module (L_DDL and L_DT)
  /// and two through the decoder (L_Rec and L_DT).
  void step_stage_1(const Batch& batch, const nets::AdamStep& adam) {
    const std::int64_t rows = batch.size();
    put(batch.reconstruction.by_acceleration, *networks_.decoder, 0);
    if (!task_.variant.physics) {
      differentiate_coder(rows, 1, Array::Zero(rows, 2), batch.k_and_c);
    } else {
      put(batch.differential.by_displacement, *networks_.module, 0);
      put(batch.differential.by_velocity, *networks_.module, 0, task_.shape.samples);
      put(batch.twin.by_displacement, *networks_.module, rows);
      put(batch.twin.by_velocity, *networks_.module, rows, task_.shape.samples);
      put(batch.twin.by_acceleration + differentiate_module(rows, 2), *networks_.decoder, rows);
      differentiate_coder(rows, 2, batch.twin.by_k_and_c, batch.k_and_c);
    }
    for (Network* network : trained()) network->take(adam, clipping(network->squared_norm()));
  }

  /// Eq. 25: all networks and the loss weights follow the total.
  void step_stage_2(const Batch& batch, const BatchLosses& losses, const nets::AdamStep& adam,
                    double rate_of_weights) {
    const std::int64_t rows = batch.size();
    const Weights w = weights();
    PerLoss<float> by_log_weights{};
    Array by_a = w.gamma * batch.reconstruction.by_acceleration;
    Array by_k_and_c = Array::Zero(rows, 2);
    if (task_.variant.physics) {
      put(w.alpha * batch.differential.by_displacement + w.beta * batch.twin.by_displacement,
          *networks_.module, 0);
      put(w.alpha * batch.differential.by_velocity + w.beta * batch.twin.by_velocity,
          *networks_.module, 0, task_.shape.samples);
      by_a += w.alpha * batch.differential.by_acceleration + w.beta * batch.twin.by_acceleration +
              differentiate_module(rows, 1);
      by_k_and_c = w.beta * batch.twin.by_k_and_c;
      if (are_learned(task_.options.loss_weights)) {
        by_log_weights = total_loss_by_log_weights(per_loss(losses), log_weights(),
                                                   have_logarithms(task_.options.loss_weights));
      }
    }
    put(by_a, *networks_.decoder, 0);
    differentiate_coder(rows, 1, by_k_and_c, batch.k_and_c);

    double squares = 0;
    for (const float x : by_log_weights) squares += static_cast<double>(x) * x;
    for (const Network* network : trained()) squares += network->squared_norm();
    const double scale = clipping(squares);
    for (Network* network : trained()) network->take(adam, scale);
    for (float& x : by_log_weights) x *= static_cast<float>(scale);
    const nets::AdamStep of_weights(++weight_steps_, rate_of_weights);
    nets::take(of_weights, parameters_->data(Kept::value) + log_weights_, by_log_weights.data(),
               parameters_->data(Kept::first_moment) + log_weights_,
               parameters_->data(Kept::second_moment) + log_weights_, by_log_weights.size());
  }

  /// Propagates the module's signals back; returns the gradient of the last signal by the module's
  /// input acceleration.
  Array differentiate_module(std::int64_t rows, std::int64_t signals) {
    return nets::copied<float>(
        networks_.module->backward(rows, signals, last_signal(rows, signals)), rows,
        task_.shape.samples);
  }

  /// Propagates the decoder's signals back. If there is an encoder, propagates the sum of the last
  /// signal and `by_k_and_c` back through it.
  void differentiate_coder(std::int64_t rows, std::int64_t signals, const Array& by_k_and_c,
                           const Array& k_and_c) {
    if (!task_.variant.encoder) {
      networks_.decoder->backward(rows, signals, nets::no_rows);
      return;
    }
    const Array by_inputs = nets::copied<float>(
        networks_.decoder->backward(rows, signals, last_signal(rows, signals)), rows, 2);
    put((by_k_and_c + by_inputs) * slope_at(k_and_c, networks_.positive), *networks_.encoder, 0);
    networks_.encoder->backward(rows, 1, nets::no_rows);
  }

  [[nodiscard]] std::vector<Network*> trained() const {
    std::vector<Network*> networks;
    for (Network* network :
         {networks_.encoder.get(), networks_.decoder.get(), networks_.module.get()}) {
      if (network) networks.push_back(network);
    }
    return networks;
  }

  /// Returns the factor that limits gradients of this squared norm to the largest permitted norm.
  [[nodiscard]] double clipping(double squares) const {
    return std::min(1.0, task_.options.max_gradient_norm / std::sqrt(squares));
  }

  TwinTask task_;
  std::unique_ptr<Coder> coder_;
  std::vector<nets::ParameterSpec> specs_;
  std::shared_ptr<Parameters> parameters_;
  std::int64_t largest_batch_;  ///< number of windows
  Networks networks_;
  Stencil stencil_;
  LossInterpretation interpretation_;
  std::int64_t log_weights_;       ///< their start among the parameters
  std::int64_t steps_ = 0;         ///< steps of Adam for the networks
  std::int64_t weight_steps_ = 0;  ///< steps of Adam for the loss weights
};

}  // namespace

Engine one_core_engine(Device /*device*/) {
  return {.train =
              [](TwinTask task, const Stream& initial) {
                return std::make_unique<OneCoreBackend>(std::move(task), initial);
              },
          .open = open_one_core_model};
}

}  // namespace piae::twin
