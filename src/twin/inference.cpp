#include "twin/inference.hpp"

#include "base/error.hpp"
#include "signal/scaling.hpp"
#include "twin/model.hpp"
#include "twin/physics.hpp"

namespace piae::twin {

std::vector<signal::DynamicParameters> infer(const artefact::Reader& model,
                                             const TwinVariant& variant,
                                             const signal::WindowSet& windows,
                                             const Engine& engine) {
  const ModelDescription description = read_model_description(model);
  if (static_cast<std::int64_t>(windows.length) != description.shape.samples ||
      windows.info.classes.size() != description.info.classes.size()) {
    throw Error(Exit::bad_input,
                model.path().string() +
                    ": was trained on windows of another length or number of classes "
                    "than the windows to infer (k, c) from; give windows of its data set");
  }
  const std::unique_ptr<StoredTwin> networks = engine.open(model, description, variant);
  std::vector<signal::DynamicParameters> inferred;
  for (const TwinPoint& point :
       networks->encode(signal::scaled_windows(windows, description.acceleration))) {
    inferred.push_back(in_units(point));
  }
  return inferred;
}

}  // namespace piae::twin
