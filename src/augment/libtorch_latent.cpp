#include "augment/libtorch_latent.hpp"

#include "nets/dense.hpp"
#include "nets/device.hpp"
#include "nets/torch.hpp"

namespace piae::augment {

namespace {

class LibtorchGenerator final : public StoredGenerator {
 public:
  LibtorchGenerator(const artefact::Reader& model, const LatentGenerator& generator,
                    torch::Device device)
      : parameters_(generator_specs(generator), Stream("replaced"), torch::kFloat32, device),
        one_hot_(torch::eye(generator.classes(), torch::device(device))) {
    parameters_.read(model, weights_group);
  }

  [[nodiscard]] std::vector<float> make(std::span<const float> z, std::size_t label) override {
    const torch::NoGradGuard no_grad;
    const torch::Tensor row =
        torch::tensor(std::vector<float>(z.begin(), z.end())).unsqueeze(0).to(one_hot_.device());
    return nets::to_vector(
        run_generator(parameters_, row, one_hot_.narrow(0, static_cast<std::int64_t>(label), 1)));
  }

 private:
  nets::ParameterSet parameters_;
  torch::Tensor one_hot_;
};

}  // namespace

torch::Tensor run_generator(const nets::ParameterSet& parameters, const torch::Tensor& z,
                            const torch::Tensor& classes) {
  return nets::run_dense_chain(parameters, generator_name, torch::cat({z, classes}, 1));
}

LibtorchLatent::LibtorchLatent(const LatentTask& task, std::vector<nets::ParameterSpec> specs,
                               const Stream& initial, const std::string& device_name)
    : latent_(task.generator.latent),
      learning_rate_(task.options.learning_rate),
      specs_(std::move(specs)),
      parameters_(specs_, initial, torch::kFloat32, nets::prepare_device(device_name)) {
  const torch::Device device = parameters_.values().device();
  known_ = {torch::tensor(task.windows).view({-1, task.generator.samples}).to(device),
            torch::one_hot(torch::tensor(task.labels, torch::kInt64), task.generator.classes())
                .to(device, torch::kFloat32)};
}

Batch LibtorchLatent::batch_of(std::span<const std::size_t> windows) const {
  const torch::Tensor rows =
      torch::tensor(std::vector<std::int64_t>(windows.begin(), windows.end()))
          .to(known_.windows.device());
  return {known_.windows.index_select(0, rows), known_.classes.index_select(0, rows)};
}

torch::Tensor LibtorchLatent::draw_z(const Batch& batch, Stream& noise) const {
  const std::int64_t rows = batch.windows.size(0);
  return torch::tensor(normal_numbers(noise, static_cast<std::size_t>(rows * latent_)))
      .view({rows, latent_})
      .to(batch.windows.device());
}

std::unique_ptr<StoredGenerator> open_generator_with_libtorch(const artefact::Reader& model,
                                                              const LatentGenerator& generator,
                                                              const std::string& device) {
  return std::make_unique<LibtorchGenerator>(model, generator, nets::prepare_device(device));
}

}  // namespace piae::augment
