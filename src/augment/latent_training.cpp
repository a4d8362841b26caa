#include "augment/latent_training.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>

#include "base/error.hpp"
#include "nets/device.hpp"
#include "nets/torch.hpp"
#include "signal/amplitude.hpp"
#include "twin/scaling.hpp"

namespace piae::augment {

namespace {

LatentGenerator make_generator(const signal::WindowSet& known, const LatentOptions& options) {
  LatentGenerator generator;
  generator.info = known.info;
  generator.samples = static_cast<std::int64_t>(known.length);
  generator.latent = options.latent;
  generator.size = {options.depth, options.width};
  generator.rms = signal::rms_by_class(known);
  return generator;
}

Batch make_batch(const signal::WindowSet& known, const LatentGenerator& generator,
                 torch::Device device) {
  const torch::Tensor labels = torch::tensor(known.labels, torch::kInt64);
  return {twin::scaled_windows(known, generator.rms).to(device),
          torch::one_hot(labels, generator.classes()).to(device, torch::kFloat32)};
}

std::vector<nets::ParameterSpec> joined(std::vector<nets::ParameterSpec> specs,
                                        const std::vector<nets::ParameterSpec>& others) {
  specs.insert(specs.end(), others.begin(), others.end());
  return specs;
}

torch::Tensor shuffled_rows(const Batch& known, const Stream& stream) {
  Stream shuffle = stream.child("order");
  const auto order = shuffle.permutation(static_cast<std::size_t>(known.windows.size(0)));
  return torch::tensor(std::vector<std::int64_t>(order.begin(), order.end()))
      .to(known.windows.device());
}

}  // namespace

LatentTraining::LatentTraining(const signal::WindowSet& known, const LatentOptions& options,
                               OtherSpecs others, const std::vector<std::string>& losses,
                               const Stream& stream, const std::string& device)
    : options_(options),
      stream_(stream),
      generator_(make_generator(known, options)),
      known_(make_batch(known, generator_, nets::prepare_device(device))),
      parameters_(joined(generator_specs(generator_), others(generator_)), stream.child("initial"),
                  torch::kFloat32, known_.windows.device()) {
  for (const std::string& loss : losses) curves_.push_back({loss, {}});
}

std::size_t LatentTraining::epochs() const { return static_cast<std::size_t>(options_.epochs); }

std::string LatentTraining::run_epoch(std::size_t epoch) {
  const Stream own = stream_.child("epoch" + std::to_string(epoch));
  Stream noise = own.child("noise");
  const std::vector<torch::Tensor> batches = shuffled_rows(known_, own).split(options_.batch);
  std::vector<double> means(curves_.size(), 0);
  for (std::size_t i = 0; i < batches.size(); ++i) {
    const Batch batch{known_.windows.index_select(0, batches[i]),
                      known_.classes.index_select(0, batches[i])};
    const std::vector<double> losses = step(epoch * batches.size() + i, batch, noise);
    for (std::size_t k = 0; k < means.size(); ++k) {
      means[k] += losses.at(k) / static_cast<double>(batches.size());
    }
  }
  return note_epoch(epoch, means);
}

torch::Tensor LatentTraining::draw_z(const Batch& batch, Stream& noise) const {
  return normal_numbers(noise, batch.windows.size(0), generator_.latent).to(batch.windows.device());
}

std::string LatentTraining::note_epoch(std::size_t epoch, const std::vector<double>& means) {
  std::string note;
  for (std::size_t k = 0; k < means.size(); ++k) {
    if (!std::isfinite(means[k])) {
      throw Error(Exit::failed, "training diverged in epoch " + std::to_string(epoch + 1) +
                                    "; a smaller --learning-rate may help");
    }
    curves_[k].means.push_back(means[k]);
    note += fmt::format("{}{} {:.3f}", k > 0 ? "  " : "", curves_[k].loss, means[k]);
  }
  return note;
}

void LatentTraining::write_state(artefact::Writer& writer) const {
  parameters_.write(writer, weights_group, parameters_.values());
  for (const Curve& curve : curves_) writer.numbers("/curves/" + curve.loss, curve.means);
}

void LatentTraining::read_state(const artefact::Reader& reader) {
  parameters_.read(reader, weights_group);
  for (Curve& curve : curves_) {
    curve.means = reader.numbers<double>("/curves/" + curve.loss, {0}).values;
  }
}

void LatentTraining::write_model(artefact::Writer& writer) const {
  write(writer, generator_);
  write_state(writer);
}

}  // namespace piae::augment
