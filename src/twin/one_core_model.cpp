#include "twin/one_core_model.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/label.hpp"
#include "nets/stored_parameters.hpp"
#include "twin/networks.hpp"

namespace piae::twin {

namespace {

using Parameters = nets::Parameters<float>;

constexpr std::int64_t windows_at_a_time = 64;

class OneCoreModel final : public StoredTwin {
 public:
  OneCoreModel(const std::shared_ptr<Parameters>& parameters, const ModelDescription& description,
               const TwinVariant& variant, const Coder& coder)
      : networks_(parameters, variant, coder, description.shape, description.options.positive,
                  windows_at_a_time) {}

  [[nodiscard]] std::vector<TwinPoint> encode(std::span<const float> windows) override {
    return encode_all(networks_, windows, windows_at_a_time);
  }

  [[nodiscard]] std::vector<float> decode(std::span<const TwinPoint> inputs, Label label) override {
    std::vector<float> windows;
    for (std::size_t i = 0; i < inputs.size(); i += windows_at_a_time) {
      const auto some =
          inputs.subspan(i, std::min<std::size_t>(windows_at_a_time, inputs.size() - i));
      const std::vector<Label> labels(some.size(), label);
      const RowArray<float> decoded = networks_.decode(as_rows(some), labels);
      windows.insert(windows.end(), decoded.data(), decoded.data() + decoded.size());
    }
    return windows;
  }

 private:
  Networks networks_;
};

/// Returns the coder of a model. If no coder supports its sizes, the error must name the model, not
/// the caller's options.
std::unique_ptr<Coder> coder_of(const artefact::Reader& model, const ModelDescription& description,
                                const TwinVariant& variant) {
  try {
    return make_coder(variant.coder, description.shape, description.options);
  } catch (const Error& error) {
    model.refuse("/", std::string("has impossible network sizes: ") + error.what());
  }
}

}  // namespace

std::unique_ptr<StoredTwin> open_one_core_model(const artefact::Reader& model,
                                                const ModelDescription& description,
                                                const TwinVariant& variant) {
  const auto coder = coder_of(model, description, variant);
  const auto specs = network_specs(variant, description.shape, description.options, coder->specs());
  const std::string group = std::string("/") + to_string(description.options.keep);
  const std::vector<float> values = nets::read_parameters(model, group, specs);
  const auto parameters = std::make_shared<Parameters>(specs, Stream("replaced"));
  parameters->write(Parameters::Kept::value, values);
  return std::make_unique<OneCoreModel>(parameters, description, variant, *coder);
}

}  // namespace piae::twin
