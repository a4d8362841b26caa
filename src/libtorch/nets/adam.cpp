#include "libtorch/nets/adam.hpp"

#include "libtorch/nets/parameters.hpp"
#include "libtorch/nets/torch.hpp"

namespace piae::libtorch {

namespace {

/// One pass over what the tensors hold, where LibTorch's operations need eight.
template <class T>
void take_flat(const nets::AdamStep& step, const torch::Tensor& values, const torch::Tensor& gradients,
               const torch::Tensor& first_moment, const torch::Tensor& second_moment) {
  take(step, values.data_ptr<T>(), gradients.data_ptr<T>(), first_moment.data_ptr<T>(),
       second_moment.data_ptr<T>(), static_cast<std::size_t>(values.numel()));
}

}  // namespace

Adam::Adam(torch::Tensor values, torch::Tensor gradients, double beta1, double beta2)
    : values_(std::move(values)),
      gradients_(std::move(gradients)),
      first_moment_(torch::zeros_like(values_)),
      second_moment_(torch::zeros_like(values_)),
      beta1_(beta1),
      beta2_(beta2) {}

void Adam::step(double learning_rate) {
  const torch::NoGradGuard no_grad;
  const nets::AdamStep step(++steps_, learning_rate, beta1_, beta2_);
  if (values_.is_cpu()) {
    return values_.scalar_type() == torch::kFloat64
               ? take_flat<double>(step, values_, gradients_, first_moment_, second_moment_)
               : take_flat<float>(step, values_, gradients_, first_moment_, second_moment_);
  }
  first_moment_.mul_(beta1_).add_(gradients_, 1 - beta1_);
  second_moment_.mul_(beta2_).addcmul_(gradients_, gradients_, 1 - beta2_);
  const torch::Tensor denominator =
      second_moment_.sqrt().mul_(step.correction).add_(nets::AdamConstants::epsilon);
  values_.addcdiv_(first_moment_, denominator, -step.rate);
}

void Adam::write(artefact::Writer& writer, const std::string& group) const {
  writer.numbers(group + "/first_moment", to_vector(first_moment_));
  writer.numbers(group + "/second_moment", to_vector(second_moment_));
  writer.attribute(group, "steps", steps_);
}

void Adam::read(const artefact::Reader& reader, const std::string& group) {
  const auto size = static_cast<std::size_t>(values_.numel());
  copy_into(first_moment_, reader.numbers<float>(group + "/first_moment", {size}).values);
  copy_into(second_moment_, reader.numbers<float>(group + "/second_moment", {size}).values);
  steps_ = reader.integer(group, "steps");
}

double clip_norm(const torch::Tensor& gradients, double max_norm) {
  const torch::NoGradGuard no_grad;
  const auto norm = gradients.norm().item<double>();
  if (norm > max_norm) gradients.mul_(max_norm / norm);
  return norm;
}

}  // namespace piae::libtorch
