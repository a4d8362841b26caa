#include "libtorch/twin/model.hpp"

#include "base/label.hpp"
#include "libtorch/nets/parameters.hpp"
#include "libtorch/nets/torch.hpp"
#include "libtorch/twin/networks.hpp"

namespace piae::libtorch {

namespace {

class Model final : public twin::StoredTwin {
 public:
  Model(const artefact::Reader& model, const twin::ModelDescription& description,
        const twin::TwinVariant& variant, torch::Device device)
      : shape_(description.shape),
        device_(device),
        networks_(variant, description.shape, description.options),
        parameters_(networks_.specs(), Stream("replaced"), torch::kFloat32, device) {
    parameters_.read(model, std::string("/") + to_string(description.options.keep));
  }

  [[nodiscard]] std::vector<twin::TwinPoint> encode(std::span<const float> windows) override {
    const torch::NoGradGuard no_grad;
    const torch::Tensor x = torch::tensor(std::vector<float>(windows.begin(), windows.end()))
                                .view({-1, shape_.samples});
    return as_points(networks_.encode(parameters_, x.to(device_)));
  }

  [[nodiscard]] std::vector<float> decode(std::span<const twin::TwinPoint> inputs,
                                          Label label) override {
    const torch::NoGradGuard no_grad;
    const torch::Tensor labels =
        torch::full({static_cast<std::int64_t>(inputs.size())}, label, torch::kInt64);
    return to_vector(
        networks_.decode(parameters_, as_tensor({inputs.begin(), inputs.end()}, device_),
                         torch::one_hot(labels, shape_.classes).to(device_, torch::kFloat32)));
  }

 private:
  twin::NetworkShape shape_;
  torch::Device device_;
  Networks networks_;
  ParameterSet parameters_;
};

}  // namespace

torch::Tensor as_tensor(const std::vector<twin::TwinPoint>& points, torch::Device device) {
  std::vector<double> flat;
  for (const twin::TwinPoint& point : points) flat.insert(flat.end(), {point.k, point.c});
  return torch::tensor(flat, torch::kFloat64).view({-1, 2}).to(device, torch::kFloat32);
}

std::vector<twin::TwinPoint> as_points(const torch::Tensor& k_and_c) {
  const std::vector<float> flat = to_vector(k_and_c);
  std::vector<twin::TwinPoint> points;
  for (std::size_t i = 0; i < flat.size(); i += 2) points.push_back({flat[i], flat[i + 1]});
  return points;
}

std::unique_ptr<twin::StoredTwin> open_model(const artefact::Reader& model,
                                             const twin::ModelDescription& description,
                                             const twin::TwinVariant& variant,
                                             torch::Device device) {
  return std::make_unique<Model>(model, description, variant, device);
}

}  // namespace piae::libtorch
