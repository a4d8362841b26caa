#include "libtorch/latent/shared.hpp"

#include "libtorch/latent/backends.hpp"

#include "libtorch/nets/dense.hpp"
#include "libtorch/nets/device.hpp"
#include "libtorch/nets/torch.hpp"

namespace piae::libtorch {

namespace {

class LibtorchGenerator final : public latent::StoredGenerator {
 public:
  LibtorchGenerator(const artefact::Reader& model, const latent::LatentGenerator& generator,
                    torch::Device device)
      : parameters_(latent::generator_specs(generator), Stream("replaced"), torch::kFloat32, device),
        one_hot_(torch::eye(generator.classes(), torch::device(device))) {
    parameters_.read(model, latent::weights_group);
  }

  [[nodiscard]] std::vector<float> make(std::span<const float> z, std::size_t label) override {
    const torch::NoGradGuard no_grad;
    const torch::Tensor row =
        torch::tensor(std::vector<float>(z.begin(), z.end())).unsqueeze(0).to(one_hot_.device());
    return to_vector(
        run_generator(parameters_, row, one_hot_.narrow(0, static_cast<std::int64_t>(label), 1)));
  }

 private:
  ParameterSet parameters_;
  torch::Tensor one_hot_;
};

}  // namespace

torch::Tensor run_generator(const ParameterSet& parameters, const torch::Tensor& z,
                            const torch::Tensor& classes) {
  return run_dense_chain(parameters, latent::generator_name, torch::cat({z, classes}, 1));
}

LibtorchLatent::LibtorchLatent(const latent::LatentTask& task, std::vector<nets::ParameterSpec> specs,
                               const Stream& initial, Device device)
    : latent_(task.generator.latent),
      learning_rate_(task.options.learning_rate),
      specs_(std::move(specs)),
      parameters_(specs_, initial, torch::kFloat32, prepare_device(device)) {
  const torch::Device place = parameters_.values().device();
  known_ = {torch::tensor(task.windows).view({-1, task.generator.samples}).to(place),
            torch::one_hot(torch::tensor(task.labels, torch::kInt64), task.generator.classes())
                .to(place, torch::kFloat32)};
}

Batch LibtorchLatent::batch_of(std::span<const std::size_t> windows) const {
  const torch::Tensor rows =
      torch::tensor(std::vector<std::int64_t>(windows.begin(), windows.end()))
          .to(known_.windows.device());
  return {known_.windows.index_select(0, rows), known_.classes.index_select(0, rows)};
}

torch::Tensor LibtorchLatent::draw_z(const Batch& batch, Stream& noise) const {
  const std::int64_t rows = batch.windows.size(0);
  return torch::tensor(latent::normal_numbers(noise, static_cast<std::size_t>(rows * latent_)))
      .view({rows, latent_})
      .to(batch.windows.device());
}

std::unique_ptr<latent::StoredGenerator> open_generator(const artefact::Reader& model,
                                                              const latent::LatentGenerator& generator,
                                                              Device device) {
  return std::make_unique<LibtorchGenerator>(model, generator, prepare_device(device));
}

}  // namespace piae::libtorch
