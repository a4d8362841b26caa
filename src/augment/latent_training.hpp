#pragma once

#include <torch/types.h>

#include <string>
#include <vector>

#include "augment/latent_generator.hpp"
#include "augment/latent_options.hpp"
#include "nets/parameters.hpp"
#include "nets/trainee.hpp"
#include "signal/window_set.hpp"

namespace piae::augment {

/// Known windows of a training step.
struct Batch {
  torch::Tensor windows;  ///< about their means, in units of their class's RMS, [n, N]
  torch::Tensor classes;  ///< one-hot, [n, classes]
};

/// Training of a LatentGenerator together with other networks, in batches of the known windows C:
/// everything but the step itself. Shuffling and noise of an epoch come from the stream's child
/// "epoch<i>".
class LatentTraining : public nets::Trainee {
 public:
  [[nodiscard]] std::size_t epochs() const override;
  /// Throws Error(failed) when a loss is no longer finite.
  std::string run_epoch(std::size_t epoch) override;
  void write_state(artefact::Writer& writer) const override;
  void read_state(const artefact::Reader& reader) override;

  /// The generator as trained, with its whole state: weights, optimisers, /curves/<loss>.
  void write_model(artefact::Writer& writer) const;

 protected:
  /// Parameters of the networks that are trained beside the generator.
  using OtherSpecs = std::vector<nets::ParameterSpec> (*)(const LatentGenerator&);

  /// `losses`: names of what a step returns. Throws Error(bad_input) when a class of C is silent.
  LatentTraining(const signal::WindowSet& known, const LatentOptions& options, OtherSpecs others,
                 const std::vector<std::string>& losses, const Stream& stream,
                 const std::string& device);

  /// One step, the index-th (from 0) of the whole training; returns its losses.
  virtual std::vector<double> step(std::size_t index, const Batch& batch, Stream& noise) = 0;

  [[nodiscard]] const LatentOptions& options() const { return options_; }
  nets::ParameterSet& parameters() { return parameters_; }
  /// z of N(0, 1) for each window of the batch, [n, latent].
  [[nodiscard]] torch::Tensor draw_z(const Batch& batch, Stream& noise) const;

 private:
  struct Curve {
    std::string loss;
    std::vector<double> means;  ///< over the steps of each epoch
  };
  std::string note_epoch(std::size_t epoch, const std::vector<double>& means);

  LatentOptions options_;
  Stream stream_;
  LatentGenerator generator_;
  Batch known_;
  nets::ParameterSet parameters_;
  std::vector<Curve> curves_;
};

}  // namespace piae::augment
