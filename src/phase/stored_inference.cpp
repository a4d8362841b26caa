#include "phase/stored_inference.hpp"

#include <spdlog/fmt/fmt.h>

#include "base/error.hpp"
#include "phase/inference.hpp"
#include "twin/physics.hpp"

namespace piae::phase {

namespace {

constexpr int windows_at_a_time = 64;

}  // namespace

std::vector<signal::DynamicParameters> infer(const artefact::Reader& model,
                                             const signal::WindowSet& windows) {
  const std::size_t classes = signal::read_dataset_info(model).classes.size();
  if (windows.info.classes.size() != classes) {
    throw Error(Exit::bad_input,
                fmt::format("{}: learned {} classes, and (k, c) is to be inferred of {}",
                            model.path().string(), classes, windows.info.classes.size()));
  }
  Inference inference(static_cast<std::int64_t>(classes),
                      static_cast<int>(model.integer("/inference", "width")), windows_at_a_time,
                      Stream("replaced"));
  inference.read(model);
  std::vector<signal::DynamicParameters> inferred;
  for (const twin::TwinPoint& point : inference.infer(windows)) {
    inferred.push_back(twin::in_units(point));
  }
  return inferred;
}

}  // namespace piae::phase
