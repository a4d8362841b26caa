#include "augment/diffusion.hpp"

#include <utility>

#include "augment/healthy_model.hpp"
#include "seam/libtorch.hpp"
#include "signal/amplitude.hpp"

namespace piae::augment {

namespace {

using diffusion::DenoiserSize;
using diffusion::Lesson;

diffusion::MakeDiffusionBackend diffusion_backend(const Compute& compute) {
  const Backends<diffusion::MakeDiffusionBackend> backends{
      .native = diffusion::one_core_diffusion,
      .libtorch = seam::back_end(&seam::BackEnds::diffusion)};
  return backends.chosen(compute);
}

/// Returns the calibrated settings of a method, those of pipeline/protocol.toml.
diffusion::DiffusionOptions defaults_of(diffusion::Path path, Diffusion::From from,
                                        diffusion::Angle angle) {
  const bool flows = path == diffusion::Path::flow;
  diffusion::DiffusionOptions options = flows ? diffusion::flow_defaults : diffusion::ddpm_defaults;
  if (from == Diffusion::From::healthy) {
    options.course.batch = 15;
    options.course.learning_rate = 4e-3;
  } else if (angle == diffusion::Angle::drawn && flows) {
    options.course.epochs = 6000;
    options.course.batch = 45;
    options.size.blocks = 6;
  } else if (angle == diffusion::Angle::drawn) {
    options.course.epochs = 4000;
    options.course.learning_rate = 4e-3;
  }
  return options;
}

}  // namespace

Diffusion::Diffusion(diffusion::Path path, From from, diffusion::Angle angle)
    : from_(from), angle_(angle), options_(defaults_of(path, from, angle)) {}

bool Diffusion::needs_libtorch(const Compute& compute) const {
  return piae::needs_libtorch(compute);
}

void Diffusion::bind(const cli::Options& command) {
  diffusion::bind(command, options_);
  if (from_ == From::healthy) diffusion::bind(command, healthy_options_);
}

void Diffusion::train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
                      const nets::Checkpoint& checkpoint, artefact::Writer& model) {
  diffusion::require_possible(options_);
  diffusion::require_whole_frames(known.length);
  std::vector<double> rms = signal::rms_by_class(known);
  std::vector<DenoiserSize> sizes;
  std::vector<Lesson> lessons;
  if (from_ == From::healthy) {
    const signal::WindowSet& healthy = require_healthy(healthy_, known);
    lessons.push_back(lesson_of(healthy, signal::rms_by_class(healthy), diffusion::Angle::known,
                                healthy_options_.course));
    sizes = {options_.size, healthy_options_.change};
  } else {
    sizes = {options_.size};
  }
  lessons.push_back(lesson_of(known, rms, angle_, options_.course));
  diffusion::DiffusionModel described{
      .info = known.info,
      .path = options_.path,
      .networks = networks_of(static_cast<std::int64_t>(known.length),
                              std::ssize(known.info.classes), sizes),
      .steps = options_.steps,
      .guidance = options_.guidance,
      .rms = std::move(rms)};
  diffusion::DiffusionTraining training(
      std::move(described), std::move(lessons), options_.dropped, stream,
      [&](const diffusion::Networks& networks, std::int64_t most, const Stream& initial) {
        return diffusion_backend(compute)(networks, most, initial, compute.device);
      });
  nets::run_epochs(training, checkpoint);
  training.write_model(model);
}

signal::WindowSet Diffusion::generate(const artefact::Reader& model, std::size_t count,
                                      const Stream& stream, const Compute& compute) {
  return diffusion::generate(model, count, stream, diffusion_backend(compute), compute.device);
}

}  // namespace piae::augment
