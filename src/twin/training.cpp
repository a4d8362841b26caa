#include "twin/training.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/error.hpp"
#include "nets/divergence.hpp"
#include "nets/stored_parameters.hpp"
#include "signal/amplitude.hpp"
#include "signal/scaling.hpp"
#include "twin/batches.hpp"
#include "twin/curves.hpp"
#include "twin/derivatives.hpp"
#include "twin/model.hpp"
#include "twin/outcome.hpp"

namespace piae::twin {

namespace {

/// Returns the divisor of the windows of each class, in the recordings' unit.
std::vector<double> unit_by_class(const signal::WindowSet& known, Unit unit) {
  switch (unit) {
    case Unit::rms:
      return signal::rms_by_class(known);
    case Unit::peak:
      return signal::peak_by_class(known);
    case Unit::recording:
      return std::vector<double>(known.info.classes.size(), 1.0);
  }
  throw std::logic_error("unknown unit");
}

ModelDescription describe(const signal::WindowSet& known, const TwinOptions& options) {
  return {.info = known.info,
          .shape = {.samples = static_cast<std::int64_t>(known.length),
                    .classes = static_cast<std::int64_t>(known.info.classes.size())},
          .options = options,
          .acceleration = unit_by_class(known, options.unit)};
}

TwinTask make_task(const signal::WindowSet& known, const ModelDescription& model,
                   const TwinVariant& variant, const std::optional<KnownStates>& states) {
  return {
      .variant = variant,
      .options = model.options,
      .shape = model.shape,
      .physics = make_physics(known.info, model.acceleration, model.shape.samples, model.options),
      .windows = signal::scaled_windows(known, model.acceleration),
      .labels = known.labels,
      .states = states};
}

/// Lower bound of a loss, so that a weight of 1 / (2 L) stays finite.
constexpr double least_loss = 1e-9;

/// Sums of the losses over the batches of an epoch.
struct EpochSums {
  BatchLosses losses;
  int batches = 0;

  void add(const BatchLosses& batch) {
    losses.reconstruction += batch.reconstruction;
    losses.differential += batch.differential;
    losses.twin += batch.twin;
    losses.total += batch.total;
    ++batches;
  }
};

void require_derivatives(const signal::WindowSet& known, const TwinOptions& options,
                         const TwinVariant& variant) {
  const auto shortest = static_cast<std::size_t>(2 * stencil_of(options.derivatives).reach + 1);
  if (!variant.physics || known.length >= shortest) return;
  throw Error(Exit::usage, fmt::format("windows of {} samples are too short for the "
                                       "physics-informed module; use {} or more",
                                       known.length, shortest));
}

class Training final : public TwinTraining {
 public:
  Training(const signal::WindowSet& known, const TwinOptions& options, const TwinVariant& variant,
           const Stream& stream, const Engine& engine, const std::optional<KnownStates>& states)
      : stream_(stream),
        model_(describe(known, options)),
        labels_(known.labels),
        has_physics_(variant.physics),
        backend_(engine.train(make_task(known, model_, variant, states), stream.child("initial"))),
        best_(values()) {}

  [[nodiscard]] std::size_t epochs() const override {
    return static_cast<std::size_t>(model_.options.epochs);
  }

  std::string run_epoch(std::size_t epoch) override {
    Stream shuffle = stream_.child("epoch" + std::to_string(epoch));
    const bool even = epoch / static_cast<std::size_t>(model_.options.stage_epochs) % 2 == 0;
    const TrainingStage stage = even ? TrainingStage::one : TrainingStage::two;
    const LearningRates rates = learning_rates_at(epoch);
    EpochSums sums;
    for (const auto& batch :
         batches_of_an_epoch(labels_, model_.options.batches,
                             static_cast<std::size_t>(model_.options.batch), shuffle)) {
      sums.add(backend_->step(stage, batch, rates));
    }
    if (has_physics_ && model_.options.loss_weights == LossWeights::stationary) {
      weigh_as_stationary(sums);
    }
    note_epoch(epoch, sums, rates.networks);
    return fmt::format("L_Rec {:.3f}  L_DDL {:.3f}  L_DT {:.3f}", curves_.reconstruction.back(),
                       curves_.differential.back(), curves_.twin.back());
  }

  void write_state(artefact::Writer& writer) const override {
    nets::write_parameters(writer, "/weights", backend_->specs(), values());
    backend_->write_adam(writer, "/adam");
    writer.numbers("/best", best_);
    writer.attribute("/", "best_loss", best_loss_);
    writer.attribute("/", "best_epoch", best_epoch_);
    curves_.write(writer);
  }

  void read_state(const artefact::Reader& reader) override {
    backend_->set_values(nets::read_parameters(reader, "/weights", backend_->specs()));
    backend_->read_adam(reader, "/adam");
    best_ = reader.numbers<float>("/best", {best_.size()}).values;
    best_loss_ = reader.real("/", "best_loss");
    best_epoch_ = reader.integer("/", "best_epoch");
    curves_.read(reader);
  }

  void write_model(artefact::Writer& writer) override {
    write(writer, model_);
    nets::write_parameters(writer, "/final", backend_->specs(), values());
    nets::write_parameters(writer, "/best", backend_->specs(), best_);
    if (model_.options.keep == Keep::best) backend_->set_values(best_);
    const std::vector<TwinPoint> states = backend_->states();
    TwinSpace(states, model_.options.space_bins).write(writer);  // eqs 14 and 15
    if (model_.options.space == SpaceOf::each_class) write_labels_of_space(writer, labels_);
    backend_->write_adam(writer, "/adam");
    writer.attribute("/", "best_epoch", best_epoch_);
    curves_.write(writer);
    if (has_physics_) write_outcome(writer, curves_, open_contacts(states));
  }

 private:
  [[nodiscard]] std::int64_t open_contacts(const std::vector<TwinPoint>& states) const {
    const Physics physics =
        make_physics(model_.info, model_.acceleration, model_.shape.samples, model_.options);
    std::int64_t count = 0;
    for (std::size_t i = 0; i < states.size(); ++i) {
      const Contact& contact = physics.contact[index_of(labels_[i])];
      if (is_open_at_rest(in_units(states[i]).stiffness_n_per_m, contact, physics)) ++count;
    }
    return count;
  }

  [[nodiscard]] std::vector<float> values() const {
    std::vector<float> values(nets::total_size(backend_->specs()));
    backend_->copy_values(values);
    return values;
  }

  /// Sets the weights to the minimum of eq. 23 for the mean losses of an epoch.
  void weigh_as_stationary(const EpochSums& sums) {
    std::vector<float> all = values();
    const auto log_weight = [&](double sum) {
      return static_cast<float>(-std::log(2 * std::max(sum / sums.batches, least_loss)));
    };
    const std::array log_weights{log_weight(sums.losses.differential), log_weight(sums.losses.twin),
                                 log_weight(sums.losses.reconstruction)};
    std::ranges::copy(log_weights, all.end() - std::ssize(log_weights));  // with_log_weights()
    backend_->set_values(all);
  }

  [[nodiscard]] LearningRates learning_rates_at(std::size_t epoch) const {
    const TwinOptions& o = model_.options;
    const std::size_t decays = epoch / static_cast<std::size_t>(o.decay_every);
    const double left = std::pow(o.decay, static_cast<double>(decays));
    return {.networks = o.learning_rate * left, .loss_weights = o.weight_learning_rate * left};
  }

  void note_epoch(std::size_t epoch, const EpochSums& sums, double learning_rate) {
    const double n = sums.batches;
    const BatchLosses& losses = sums.losses;
    curves_.reconstruction.push_back(losses.reconstruction / n);
    curves_.differential.push_back(losses.differential / n);
    curves_.twin.push_back(losses.twin / n);
    curves_.total.push_back(losses.total / n);
    curves_.learning_rate.push_back(learning_rate);
    const auto [log_alpha, log_beta, log_gamma] = backend_->log_weights();
    curves_.alpha.push_back(std::exp(log_alpha));
    curves_.beta.push_back(std::exp(log_beta));
    curves_.gamma.push_back(std::exp(log_gamma));
    // The loss weights change, so the totals of two epochs cannot be compared. The plain sum of the
    // losses can.
    const double loss = (losses.reconstruction + losses.differential + losses.twin) / n;
    nets::require_finite(loss, "training", epoch + 1, {.value = model_.options.learning_rate});
    if (loss < best_loss_) {
      best_loss_ = loss;
      best_epoch_ = static_cast<std::int64_t>(epoch) + 1;
      backend_->copy_values(best_);
    }
  }

  Stream stream_;
  ModelDescription model_;
  std::vector<Label> labels_;  // classes of the known windows
  bool has_physics_;
  std::unique_ptr<TwinBackend> backend_;
  std::vector<float> best_;  // values of all parameters after the best epoch
  double best_loss_ = std::numeric_limits<double>::infinity();
  std::int64_t best_epoch_ = 0;
  Curves curves_;
};

}  // namespace

std::unique_ptr<TwinTraining> make_twin_training(const signal::WindowSet& known,
                                                 const TwinOptions& options,
                                                 const TwinVariant& variant, const Stream& stream,
                                                 const Engine& engine,
                                                 const std::optional<KnownStates>& states) {
  require_derivatives(known, options, variant);
  return std::make_unique<Training>(known, options, variant, stream, engine, states);
}

}  // namespace piae::twin
