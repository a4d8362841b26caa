#pragma once

#include <torch/types.h>

#include <cstdint>
#include <string>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "nets/adam.hpp"

namespace piae::libtorch {

/// Adam (Kingma and Ba 2015, Algorithm 1) for parameters in one flat tensor, without weight decay.
/// The mathematics is that of torch::optim::Adam, but the state is two plain tensors and a count.
class Adam {
 public:
  /// Both tensors are flat and of one size. They must share their memory with those of a
  /// ParameterSet (values() and gradients()), so that a step changes its parameters.
  Adam(torch::Tensor values, torch::Tensor gradients, double beta1 = nets::AdamConstants::beta1,
       double beta2 = nets::AdamConstants::beta2);

  void step(double learning_rate);

  /// Write and read the state, as nets::AdamState in `group`.
  void write(artefact::Writer& writer, const std::string& group) const;
  void read(const artefact::Reader& reader, const std::string& group);

 private:
  torch::Tensor values_;
  torch::Tensor gradients_;
  torch::Tensor first_moment_;
  torch::Tensor second_moment_;
  double beta1_;
  double beta2_;
  std::int64_t steps_ = 0;
};

/// Scales the gradients so that their Euclidean norm is at most `max_norm`. Returns the previous
/// norm.
double clip_norm(const torch::Tensor& gradients, double max_norm);

}  // namespace piae::libtorch
