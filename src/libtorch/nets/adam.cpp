#include "libtorch/nets/adam.hpp"

#include "libtorch/nets/parameters.hpp"
#include "libtorch/nets/torch.hpp"
#include "nets/stored_parameters.hpp"

namespace piae::libtorch {

namespace {

/// Takes a step in one pass over the memory of the tensors; LibTorch's operations would need eight
/// passes.
template <class T>
void take_flat(const nets::AdamStep& step, const torch::Tensor& values,
               const torch::Tensor& gradients, const torch::Tensor& first_moment,
               const torch::Tensor& second_moment) {
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
  nets::write(writer, group,
              nets::AdamState{.first_moment = to_vector(first_moment_),
                              .second_moment = to_vector(second_moment_),
                              .steps = steps_});
}

void Adam::read(const artefact::Reader& reader, const std::string& group) {
  const nets::AdamState state =
      nets::read_adam_state(reader, group, static_cast<std::size_t>(values_.numel()));
  copy_into(first_moment_, state.first_moment);
  copy_into(second_moment_, state.second_moment);
  steps_ = state.steps;
}

double clip_norm(const torch::Tensor& gradients, double max_norm) {
  const torch::NoGradGuard no_grad;
  const auto norm = gradients.norm().item<double>();
  if (norm > max_norm) gradients.mul_(max_norm / norm);
  return norm;
}

}  // namespace piae::libtorch
