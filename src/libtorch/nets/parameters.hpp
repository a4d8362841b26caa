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

/// All parameters of a model in one flat tensor, and their gradients in another. So Adam, gradient
/// clipping and checkpoints each make one pass over contiguous memory. Every tensor that this class
/// returns is a view of these two, and autograd adds its gradients directly into the flat one.
class ParameterSet {
 public:
  /// Initial values come from the stream, by nets::initial_values().
  ParameterSet(std::vector<nets::ParameterSpec> specs, const Stream& stream,
               torch::Dtype dtype = torch::kFloat32, torch::Device device = torch::kCPU);

  /// Returns the parameter of that name, a leaf that requires a gradient. Throws std::logic_error
  /// if it does not exist.
  [[nodiscard]] const torch::Tensor& operator[](const std::string& name) const;
  /// Returns the parameters whose names begin with `prefix`, in the order of the specs.
  [[nodiscard]] std::vector<torch::Tensor> with_prefix(const std::string& prefix) const;

  /// Return the flat values and gradients [size] of the parameters whose names begin with `prefix`.
  /// Throw std::logic_error if these are not consecutive in the specs.
  [[nodiscard]] torch::Tensor values(const std::string& prefix = "") const;
  [[nodiscard]] torch::Tensor gradients(const std::string& prefix = "") const;
  void zero_gradients();
  /// Sets the gradients of with_prefix(prefix) to those that torch::autograd::grad returned for
  /// them.
  void set_gradients(const std::string& prefix, const std::vector<torch::Tensor>& gradients);

  /// Reads the output of nets::write_parameters() (nets/stored_parameters.hpp). Throws
  /// artefact::Refusal if a parameter is missing or has another shape.
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

/// Converts the numbers of a tensor to float32, and back into a tensor of the same size.
std::vector<float> to_vector(const torch::Tensor& tensor);
void copy_into(const torch::Tensor& tensor, std::span<const float> values);

}  // namespace piae::libtorch
