#include "phase/stored_inference.hpp"

#include <spdlog/fmt/fmt.h>

#include "base/error.hpp"
#include "nets/ranges.hpp"
#include "nets/stored_parameters.hpp"
#include "twin/physics.hpp"

namespace piae::phase {

namespace {

constexpr int windows_at_a_time = 64;

}  // namespace

std::unique_ptr<Inference> read_inference(const artefact::Reader& model) {
  const auto classes = static_cast<std::int64_t>(signal::read_dataset_info(model).classes.size());
  const auto width = static_cast<int>(model.integer("/inference", "width", nets::ranges::width));
  (void)nets::read_parameters(model, Inference::group, Inference::specs_of(classes, width));
  auto inference =
      std::make_unique<Inference>(classes, width, windows_at_a_time, Stream("replaced"));
  inference->read(model);
  return inference;
}

std::vector<signal::DynamicParameters> infer(const artefact::Reader& model,
                                             const signal::WindowSet& windows) {
  const std::size_t classes = signal::read_dataset_info(model).classes.size();
  if (windows.info.classes.size() != classes) {
    throw Error(
        Exit::bad_input,
        fmt::format(
            "{}: was trained on {} classes, but the windows have {}; give windows of its data set",
            model.path().string(), classes, windows.info.classes.size()));
  }
  const std::unique_ptr<Inference> inference = read_inference(model);
  std::vector<signal::DynamicParameters> inferred;
  for (const twin::TwinPoint& point : inference->infer(windows)) {
    inferred.push_back(twin::in_units(point));
  }
  return inferred;
}

}  // namespace piae::phase
