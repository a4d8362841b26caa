#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/label.hpp"
#include "latent/backend.hpp"
#include "nets/dense_chain.hpp"
#include "nets/parameters.hpp"
#include "nets/row_array.hpp"

namespace piae::latent {

/// Base of our own back ends of the VAE and the WGAN-GP, which run on one core. Owns the task, the
/// parameters and the generator.
class DenseBackend : public LatentBackend {
 public:
  [[nodiscard]] const std::vector<nets::ParameterSpec>& specs() const override { return specs_; }
  [[nodiscard]] std::vector<float> values() const override {
    return parameters_->read(Kept::value);
  }
  void set_values(std::span<const float> values) override {
    parameters_->write(Kept::value, values);
  }

 protected:
  using Array = nets::RowArray<float>;
  using Chain = nets::DenseChain<float>;
  using Kept = nets::Parameters<float>::Kept;

  /// The known windows of a step.
  struct Batch {
    Array windows;  ///< [n, N]
    std::vector<Label> labels;

    [[nodiscard]] std::int64_t size() const { return windows.rows(); }
  };

  /// `specs` are the parameters of the generator and of the second network.
  DenseBackend(LatentTask task, std::vector<nets::ParameterSpec> specs, const Stream& initial);

  [[nodiscard]] Batch batch_of(std::span<const std::size_t> windows) const;
  /// Draws z from N(0, 1) for each window of a batch, [n, latent].
  [[nodiscard]] Array draw_z(const Batch& batch, Stream& noise) const;
  /// Returns the windows [n, N] that the generator makes from z [n, latent] and the classes of the
  /// batch.
  Array generate(const Array& z, const Batch& batch);
  /// Fills the input of a chain, from row `first` on, with `rows`, each followed by the one-hot
  /// label of its window.
  void feed(Chain& chain, const Array& rows, const Batch& batch, std::int64_t first = 0) const;

  LatentTask task_;
  std::vector<nets::ParameterSpec> specs_;
  std::shared_ptr<nets::Parameters<float>> parameters_;
  std::int64_t largest_batch_;  ///< number of windows
  Chain generator_;
};

}  // namespace piae::latent
