#include "latent/training.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "nets/divergence.hpp"
#include "nets/stored_parameters.hpp"
#include "signal/amplitude.hpp"
#include "signal/scaling.hpp"

namespace piae::latent {

namespace {

LatentGenerator describe(const signal::WindowSet& known, const LatentOptions& options) {
  return {.info = known.info,
          .samples = static_cast<std::int64_t>(known.length),
          .latent = options.latent,
          .size = {.depth = options.depth, .width = options.width},
          .rms = signal::rms_by_class(known)};
}

LatentTask make_task(const signal::WindowSet& known, const LatentOptions& options,
                     const LatentGenerator& generator) {
  return {.generator = generator,
          .options = options,
          .windows = signal::scaled_windows(known, generator.rms),
          .labels = known.labels};
}

}  // namespace

LatentTraining::LatentTraining(const signal::WindowSet& known, const LatentOptions& options,
                               const std::vector<std::string>& losses, const Stream& stream,
                               const MakeBackend& make_backend)
    : stream_(stream),
      options_(options),
      generator_(describe(known, options)),
      windows_(known.size()),
      backend_(make_backend(make_task(known, options, generator_), stream.child("initial"))) {
  for (const std::string& loss : losses) curves_.push_back({.loss = loss, .means = {}});
}

std::size_t LatentTraining::epochs() const { return static_cast<std::size_t>(options_.epochs); }

std::string LatentTraining::run_epoch(std::size_t epoch) {
  const Stream own = stream_.child("epoch" + std::to_string(epoch));
  Stream noise = own.child("noise");
  Stream shuffle = own.child("order");
  const std::vector<std::size_t> order = shuffle.permutation(windows_);
  const auto batch = static_cast<std::size_t>(options_.batch);
  const std::size_t batches = (order.size() + batch - 1) / batch;
  std::vector<double> means(curves_.size(), 0);
  for (std::size_t i = 0; i < batches; ++i) {
    const auto windows =
        std::span(order).subspan(i * batch, std::min(batch, order.size() - i * batch));
    const std::vector<double> losses = backend_->step(epoch * batches + i, windows, noise);
    for (std::size_t k = 0; k < means.size(); ++k) {
      means[k] += losses.at(k) / static_cast<double>(batches);
    }
  }
  return note_epoch(epoch, means);
}

std::string LatentTraining::note_epoch(std::size_t epoch, const std::vector<double>& means) {
  std::string note;
  for (std::size_t k = 0; k < means.size(); ++k) {
    nets::require_finite(means[k], "training", epoch + 1, {.value = options_.learning_rate});
    curves_[k].means.push_back(means[k]);
    note += fmt::format("{}{} {:.3f}", k > 0 ? "  " : "", curves_[k].loss, means[k]);
  }
  return note;
}

void LatentTraining::write_state(artefact::Writer& writer) const {
  nets::write_parameters(writer, weights_group, backend_->specs(), backend_->values());
  for (const Curve& curve : curves_) writer.numbers("/curves/" + curve.loss, curve.means);
  backend_->write_adam(writer);
}

void LatentTraining::read_state(const artefact::Reader& reader) {
  backend_->set_values(nets::read_parameters(reader, weights_group, backend_->specs()));
  for (Curve& curve : curves_) {
    curve.means = reader.numbers<double>("/curves/" + curve.loss, {0}).values;
  }
  backend_->read_adam(reader);
}

void LatentTraining::write_model(artefact::Writer& writer) const {
  write(writer, generator_);
  write_state(writer);
}

}  // namespace piae::latent
