#include <cmath>
#include <string>
#include <utility>

#include "diffusion/backend.hpp"
#include "nets/parameters.hpp"
#include "nets/row_array.hpp"

namespace piae::diffusion {

namespace {

using Parameters = nets::Parameters<float>;
using Kept = Parameters::Kept;

class OneCoreDiffusion final : public DiffusionBackend {
 public:
  OneCoreDiffusion(Networks networks, std::int64_t most_windows, const Stream& initial)
      : denoisers_(std::move(networks)),
        specs_(specs_of(denoisers_)),
        parameters_(std::make_shared<Parameters>(specs_, initial)),
        steps_(denoisers_.size(), 0) {
    for (const Denoiser& denoiser : denoisers_) {
      networks_.push_back(make_network<float>(denoiser, parameters_, most_windows));
    }
  }

  std::vector<float> velocities(const NoisyBatch& batch, std::size_t networks) override {
    const nets::RowArray<float> sum = sum_of(batch, networks);
    return {sum.data(), sum.data() + sum.size()};
  }

  double step(std::size_t trained, const NoisyBatch& batch, std::span<const float> velocities,
              double learning_rate) override {
    const std::int64_t n = batch.size();
    const std::int64_t samples = denoisers_.front().samples;
    const nets::RowArray<float> error =
        sum_of(batch, trained + 1) -
        Eigen::Map<const nets::RowArray<float>>(velocities.data(), n, samples);
    nets::Network<float>& network = *networks_[trained];
    const float per_number = 2.0F / static_cast<float>(n * samples);
    nets::put<float>(error * per_number, network.output_gradient());
    network.backward(n, 1, nets::no_rows);
    const double norm = std::sqrt(network.squared_norm());
    network.take(nets::AdamStep(++steps_[trained], learning_rate),
                 norm > largest_gradient_norm ? largest_gradient_norm / norm : 1);
    return static_cast<double>(error.square().mean());
  }

  [[nodiscard]] const std::vector<nets::ParameterSpec>& specs() const override { return specs_; }
  [[nodiscard]] std::vector<float> values() const override {
    return parameters_->read(Kept::value);
  }
  void set_values(std::span<const float> values) override {
    parameters_->write(Kept::value, values);
  }
  void write_adam(artefact::Writer& writer) const override {
    for (std::size_t i = 0; i < denoisers_.size(); ++i) {
      write_moments(writer, "/adam/" + denoisers_[i].name, *parameters_, denoisers_[i].name + "/",
                    steps_[i]);
    }
  }
  void read_adam(const artefact::Reader& reader) override {
    for (std::size_t i = 0; i < denoisers_.size(); ++i) {
      steps_[i] = read_moments(reader, "/adam/" + denoisers_[i].name, *parameters_,
                               denoisers_[i].name + "/");
    }
  }

 private:
  nets::RowArray<float> sum_of(const NoisyBatch& batch, std::size_t networks) {
    const std::int64_t n = batch.size();
    const std::int64_t samples = denoisers_.front().samples;
    nets::RowArray<float> sum = nets::RowArray<float>::Zero(n, samples);
    for (std::size_t k = 0; k < networks; ++k) {
      for (std::int64_t i = 0; i < n; ++i) {
        const auto at = static_cast<std::size_t>(i);
        fill_input(denoisers_[k], batch.windows.data() + i * samples, batch.u[at], batch.labels[at],
                   networks_[k]->input().row(i));
      }
      sum += nets::copied(networks_[k]->forward(n), n, samples);
    }
    return sum;
  }

  Networks denoisers_;
  std::vector<nets::ParameterSpec> specs_;
  std::shared_ptr<Parameters> parameters_;
  std::vector<std::unique_ptr<nets::Network<float>>> networks_;
  std::vector<std::int64_t> steps_;  ///< of Adam, for each network
};

}  // namespace

std::vector<nets::ParameterSpec> specs_of(const Networks& networks) {
  std::vector<nets::ParameterSpec> specs;
  for (const Denoiser& denoiser : networks) nets::append(specs, denoiser_specs(denoiser));
  return specs;
}

std::unique_ptr<DiffusionBackend> one_core_diffusion(const Networks& networks,
                                                     std::int64_t most_windows,
                                                     const Stream& initial, Device /*device*/) {
  return std::make_unique<OneCoreDiffusion>(networks, most_windows, initial);
}

}  // namespace piae::diffusion
