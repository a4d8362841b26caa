#include "twin/dense_model.hpp"

#include <algorithm>

#include "nets/stored_parameters.hpp"
#include "twin/networks.hpp"

namespace piae::twin {

namespace {

constexpr std::int64_t windows_at_a_time = 64;

class DenseModel final : public StoredTwin {
 public:
  DenseModel(const artefact::Reader& model, const ModelDescription& description,
              const TwinVariant& variant)
      : specs_(network_specs(variant, description.shape, description.options,
                             dense_coder_specs(description.shape, description.options))),
        parameters_(specs_, Stream("replaced")),
        networks_(parameters_, variant, description.shape, windows_at_a_time) {
    parameters_.write(nets::Parameters<float>::Kept::value,
                      nets::read_parameters(model, "/" + description.options.keep, specs_));
  }

  [[nodiscard]] std::vector<TwinPoint> encode(std::span<const float> windows) override {
    return encode_all(networks_, windows, windows_at_a_time);
  }

  [[nodiscard]] std::vector<float> decode(std::span<const TwinPoint> inputs,
                                          std::size_t label) override {
    std::vector<float> windows;
    for (std::size_t i = 0; i < inputs.size(); i += windows_at_a_time) {
      const auto some =
          inputs.subspan(i, std::min<std::size_t>(windows_at_a_time, inputs.size() - i));
      const std::vector<std::int32_t> labels(some.size(), static_cast<std::int32_t>(label));
      const RowArray<float> decoded = networks_.decode(as_rows(some), labels);
      windows.insert(windows.end(), decoded.data(), decoded.data() + decoded.size());
    }
    return windows;
  }

 private:
  std::vector<nets::ParameterSpec> specs_;
  nets::Parameters<float> parameters_;
  Networks networks_;
};

}  // namespace

std::unique_ptr<StoredTwin> open_dense_model(const artefact::Reader& model,
                                        const ModelDescription& description,
                                        const TwinVariant& variant) {
  return std::make_unique<DenseModel>(model, description, variant);
}

}  // namespace piae::twin
