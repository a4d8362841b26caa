#include "libtorch/latent/shared.hpp"

#include "base/label.hpp"
#include "libtorch/latent/backends.hpp"
#include "libtorch/nets/dense.hpp"
#include "libtorch/nets/device.hpp"
#include "libtorch/nets/torch.hpp"

namespace piae::libtorch {

namespace {

class Generator final : public latent::StoredGenerator {
 public:
  Generator(const artefact::Reader& model, const latent::LatentGenerator& generator,
            torch::Device device)
      : parameters_(latent::generator_specs(generator), Stream("replaced"), torch::kFloat32,
                    device),
        one_hot_(torch::eye(generator.classes(), torch::device(device))) {
    parameters_.read(model, latent::weights_group);
  }

  [[nodiscard]] std::vector<float> make(std::span<const float> z, Label label) override {
    const torch::NoGradGuard no_grad;
    const torch::Tensor row =
        torch::tensor(std::vector<float>(z.begin(), z.end())).unsqueeze(0).to(one_hot_.device());
    return to_vector(run_generator(parameters_, row, one_hot_.narrow(0, label, 1)));
  }

 private:
  ParameterSet parameters_;
  torch::Tensor one_hot_;  // row i belongs to label i
};

}  // namespace

torch::Tensor run_generator(const ParameterSet& parameters, const torch::Tensor& z,
                            const torch::Tensor& classes) {
  return run_dense_chain(parameters, latent::generator_name, torch::cat({z, classes}, 1));
}

SharedBackend::SharedBackend(const latent::LatentTask& task, std::vector<nets::ParameterSpec> specs,
                             const Stream& initial, Device device)
    : latent_(task.generator.latent),
      learning_rate_(task.options.learning_rate),
      specs_(std::move(specs)),
      parameters_(specs_, initial, torch::kFloat32, prepare_device(device)) {
  const torch::Device place = parameters_.values().device();
  const torch::Tensor labels = torch::tensor(task.labels, torch::kInt64);
  known_ = {.windows = torch::tensor(task.windows).view({-1, task.generator.samples}).to(place),
            .classes = torch::one_hot(labels, task.generator.classes()).to(place, torch::kFloat32)};
}

Batch SharedBackend::batch_of(std::span<const std::size_t> windows) const {
  const torch::Tensor rows =
      torch::tensor(std::vector<std::int64_t>(windows.begin(), windows.end()))
          .to(known_.windows.device());
  return {.windows = known_.windows.index_select(0, rows),
          .classes = known_.classes.index_select(0, rows)};
}

torch::Tensor SharedBackend::draw_z(const Batch& batch, Stream& noise) const {
  const std::int64_t rows = batch.windows.size(0);
  return torch::tensor(latent::normal_numbers(noise, static_cast<std::size_t>(rows * latent_)))
      .view({rows, latent_})
      .to(batch.windows.device());
}

std::unique_ptr<latent::StoredGenerator> open_generator(const artefact::Reader& model,
                                                        const latent::LatentGenerator& generator,
                                                        Device device) {
  return std::make_unique<Generator>(model, generator, prepare_device(device));
}

}  // namespace piae::libtorch
