#pragma once

#include <torch/types.h>

#include <cstdint>
#include <string>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "nets/adam.hpp"

namespace piae::libtorch {

/// Adam (Kingma and Ba 2015, Algorithm 1) over one flat vector of parameters, without weight decay.
/// The same mathematics as torch::optim::Adam, with a state that is three plain arrays.
class Adam {
 public:
  /// Both tensors are flat, of one size, and are only borrowed: ParameterSet owns them.
  Adam(torch::Tensor values, torch::Tensor gradients, double beta1 = nets::AdamConstants::beta1,
       double beta2 = nets::AdamConstants::beta2);

  void step(double learning_rate);

  /// Moments and step count, as <group>/first_moment, <group>/second_moment, attribute `steps`.
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

/// Scales the gradients so that their Euclidean norm is at most `max_norm`; returns the norm that
/// they had.
double clip_norm(const torch::Tensor& gradients, double max_norm);

}  // namespace piae::libtorch
