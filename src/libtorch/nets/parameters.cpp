#include "libtorch/nets/parameters.hpp"

#include <stdexcept>

#include "libtorch/nets/torch.hpp"
#include "nets/stored_parameters.hpp"

namespace piae::libtorch {

ParameterSet::ParameterSet(std::vector<nets::ParameterSpec> specs, const Stream& stream,
                           torch::Dtype dtype, torch::Device device)
    : specs_(std::move(specs)) {
  std::vector<double> initial;
  for (const nets::ParameterSpec& spec : specs_) {
    const std::vector<double> values = nets::initial_values(spec, stream);
    initial.insert(initial.end(), values.begin(), values.end());
  }
  values_ = torch::tensor(initial, torch::kFloat64).to(device, dtype);
  gradients_ = torch::zeros_like(values_);
  std::int64_t begin = 0;
  for (const nets::ParameterSpec& spec : specs_) {
    const std::int64_t size = spec.size();
    torch::Tensor view = values_.narrow(0, begin, size).view(spec.shape).detach();
    view.requires_grad_();
    view.mutable_grad() = gradients_.narrow(0, begin, size).view(spec.shape);
    tensors_[spec.name] = view;
    begin += size;
  }
}

const torch::Tensor& ParameterSet::operator[](const std::string& name) const {
  const auto found = tensors_.find(name);
  if (found == tensors_.end()) throw std::logic_error("no parameter is called " + name);
  return found->second;
}

std::vector<torch::Tensor> ParameterSet::with_prefix(const std::string& prefix) const {
  std::vector<torch::Tensor> tensors;
  for (const nets::ParameterSpec& spec : specs_) {
    if (spec.name.starts_with(prefix)) tensors.push_back(tensors_.at(spec.name));
  }
  return tensors;
}

ParameterSet::Range ParameterSet::range_of(const std::string& prefix) const {
  Range range{.begin = -1, .end = -1};
  std::int64_t begin = 0;
  for (const nets::ParameterSpec& spec : specs_) {
    const std::int64_t end = begin + spec.size();
    if (spec.name.starts_with(prefix)) {
      if (range.begin >= 0 && range.end != begin) {
        throw std::logic_error("parameters " + prefix + "* are not contiguous");
      }
      if (range.begin < 0) range.begin = begin;
      range.end = end;
    }
    begin = end;
  }
  if (range.begin < 0) throw std::logic_error("no parameter begins with " + prefix);
  return range;
}

torch::Tensor ParameterSet::values(const std::string& prefix) const {
  const Range range = range_of(prefix);
  return values_.narrow(0, range.begin, range.end - range.begin);
}

torch::Tensor ParameterSet::gradients(const std::string& prefix) const {
  const Range range = range_of(prefix);
  return gradients_.narrow(0, range.begin, range.end - range.begin);
}

void ParameterSet::zero_gradients() { gradients_.zero_(); }

void ParameterSet::set_gradients(const std::string& prefix,
                                 const std::vector<torch::Tensor>& gradients) {
  const torch::NoGradGuard no_grad;
  std::vector<torch::Tensor> tensors = with_prefix(prefix);
  for (std::size_t i = 0; i < tensors.size(); ++i) tensors[i].mutable_grad().copy_(gradients.at(i));
}

void ParameterSet::read(const artefact::Reader& reader, const std::string& group) {
  copy_into(values_, nets::read_parameters(reader, group, specs_));
}

std::vector<float> to_vector(const torch::Tensor& tensor) {
  const torch::Tensor flat = tensor.detach().to(torch::kCPU, torch::kFloat32).contiguous();
  const float* data = flat.data_ptr<float>();
  return {data, data + flat.numel()};
}

void copy_into(const torch::Tensor& tensor, std::span<const float> values) {
  const torch::NoGradGuard no_grad;
  const torch::Tensor source =
      torch::from_blob(const_cast<float*>(values.data()),
                       {static_cast<std::int64_t>(values.size())}, torch::kFloat32);
  tensor.copy_(source.view(tensor.sizes()));
}

}  // namespace piae::libtorch
