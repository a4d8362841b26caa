#include "twin/inputs.hpp"

#include "nets/torch.hpp"

namespace piae::twin {

torch::Tensor as_tensor(const std::vector<TwinPoint>& points, torch::Device device) {
  std::vector<double> flat;
  for (const TwinPoint& point : points) flat.insert(flat.end(), {point.k, point.c});
  return torch::tensor(flat, torch::kFloat64).view({-1, 2}).to(device, torch::kFloat32);
}

torch::Tensor one_hot_of(std::size_t label, std::int64_t classes, std::size_t count,
                         torch::Device device) {
  const torch::Tensor labels = torch::full({static_cast<std::int64_t>(count)},
                                           static_cast<std::int64_t>(label), torch::kInt64);
  return torch::one_hot(labels, classes).to(device, torch::kFloat32);
}

}  // namespace piae::twin
