#pragma once

#include <torch/types.h>

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "base/random.hpp"
#include "nets/parameter_spec.hpp"

namespace piae::libtorch {

/// All parameters of a model in one flat vector, and their gradients in another: the optimiser,
/// gradient clipping and checkpoints each are one pass over contiguous memory. Every tensor that
/// is handed out is a view, and autograd adds its gradients straight into the flat one.
class ParameterSet {
 public:
  /// Initial values come from the stream's children by parameter name, so that they do not depend
  /// on what else the model holds.
  ParameterSet(std::vector<nets::ParameterSpec> specs, const Stream& stream,
               torch::Dtype dtype = torch::kFloat32, torch::Device device = torch::kCPU);

  /// The parameter of that name: a leaf that requires a gradient. Throws std::logic_error.
  [[nodiscard]] const torch::Tensor& operator[](const std::string& name) const;
  /// Parameters whose names begin with `prefix`, in order.
  [[nodiscard]] std::vector<torch::Tensor> with_prefix(const std::string& prefix) const;

  /// Flat values and gradients [size], of all or of the parameters whose names begin with
  /// `prefix`, which must stand next to each other.
  [[nodiscard]] torch::Tensor values(const std::string& prefix = "") const;
  [[nodiscard]] torch::Tensor gradients(const std::string& prefix = "") const;
  void zero_gradients();
  /// Puts the gradients that torch::autograd::grad returned for with_prefix(prefix) in place.
  void set_gradients(const std::string& prefix, const std::vector<torch::Tensor>& gradients);

  /// What nets::write_parameters() wrote (stored_parameters.hpp).
  /// Throws artefact::Refusal when a parameter is missing or has another shape.
  void read(const artefact::Reader& reader, const std::string& group);

 private:
  struct Range {
    std::int64_t begin;
    std::int64_t end;
  };
  [[nodiscard]] Range range_of(const std::string& prefix) const;

  std::vector<nets::ParameterSpec> specs_;
  std::map<std::string, torch::Tensor> tensors_;
  torch::Tensor values_;
  torch::Tensor gradients_;
};

/// A flat tensor as float32 numbers and back; the shape must fit.
std::vector<float> to_vector(const torch::Tensor& tensor);
void copy_into(const torch::Tensor& tensor, std::span<const float> values);

}  // namespace piae::libtorch
