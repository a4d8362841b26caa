#include "twin/inference.hpp"

#include "base/error.hpp"
#include "nets/device.hpp"
#include "nets/torch.hpp"
#include "twin/model.hpp"
#include "twin/physics.hpp"
#include "twin/scaling.hpp"

namespace piae::twin {

std::vector<signal::DynamicParameters> infer(const artefact::Reader& model,
                                             const TwinVariant& variant,
                                             const signal::WindowSet& windows,
                                             const std::string& device_name) {
  const torch::NoGradGuard no_grad;
  const torch::Device device = nets::prepare_device(device_name);
  const ModelDescription description = read_model_description(model);
  if (static_cast<std::int64_t>(windows.length) != description.shape.samples ||
      windows.info.classes.size() != description.info.classes.size()) {
    throw Error(Exit::bad_input, model.path().string() +
                                     ": learned windows of another length or number of classes "
                                     "than those to infer (k, c) of");
  }
  const Networks networks(variant, description.shape, description.options);
  nets::ParameterSet parameters(networks.specs(), Stream("initial"), torch::kFloat32, device);
  parameters.read(model, "/" + description.options.keep);
  const std::vector<float> flat = nets::to_vector(
      networks.encode(parameters, scaled_windows(windows, description.acceleration).to(device)));
  std::vector<signal::DynamicParameters> inferred;
  for (std::size_t i = 0; i < flat.size(); i += 2) {
    inferred.push_back(in_units({flat[i], flat[i + 1]}));
  }
  return inferred;
}

}  // namespace piae::twin
