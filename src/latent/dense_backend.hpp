#pragma once

#include <span>
#include <string>
#include <vector>

#include "latent/backend.hpp"
#include "nets/dense_chain.hpp"
#include "nets/parameters.hpp"
#include "nets/row_array.hpp"

namespace piae::latent {

/// What our back ends of the VAE and the WGAN-GP share: parameters, known windows and the
/// generator, for one core.
class DenseBackend : public LatentBackend {
 public:
  [[nodiscard]] const std::vector<nets::ParameterSpec>& specs() const override { return specs_; }
  [[nodiscard]] std::vector<float> values() const override { return parameters_.read(Kept::value); }
  void set_values(std::span<const float> values) override {
    parameters_.write(Kept::value, values);
  }

 protected:
  using Array = nets::RowArray<float>;
  using Chain = nets::DenseChain<float>;
  using Kept = nets::Parameters<float>::Kept;

  /// Known windows of a step.
  struct Batch {
    Array windows;  ///< [n, N]
    std::vector<std::int32_t> labels;

    [[nodiscard]] std::int64_t size() const { return windows.rows(); }
  };

  DenseBackend(const LatentTask& task, std::vector<nets::ParameterSpec> specs,
               const Stream& initial);

  [[nodiscard]] Batch batch_of(std::span<const std::size_t> windows) const;
  /// z of N(0, 1) for each window of a batch, [n, latent].
  [[nodiscard]] Array draw_z(const Batch& batch, Stream& noise) const;
  /// The generator's windows [n, N] for z and the batch's classes.
  Array generate(const Array& z, const Batch& batch);
  /// Rows, and one-hot labels behind them, as the input of a chain from a row on.
  void feed(Chain& chain, const Array& rows, const Batch& batch, std::int64_t first = 0) const;

  const LatentTask& task_;
  std::vector<nets::ParameterSpec> specs_;
  nets::Parameters<float> parameters_;
  std::int64_t batch_;  ///< windows in the largest
  Chain generator_;
};

}  // namespace piae::latent
