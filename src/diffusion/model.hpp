#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/compute.hpp"
#include "base/random.hpp"
#include "diffusion/backend.hpp"
#include "diffusion/path.hpp"
#include "signal/window_set.hpp"

namespace piae::diffusion {

/// Group of a model that holds the weights.
inline const std::string weights_group = "/final";

/// A diffusion or flow model without its weights.
struct DiffusionModel {
  signal::DatasetInfo info;
  Path path = Path::diffusion;
  Networks networks;
  int steps = 0;            ///< from noise to a window
  double guidance = 0;      ///< w: v(class) + w (v(class) - v(no class))
  std::vector<double> rms;  ///< of each class's known windows, in the recordings' unit

  [[nodiscard]] std::int64_t samples() const { return networks.front().samples; }
};

/// Returns one or two networks of these sizes: that of all windows; or that of healthy windows,
/// without the class as an input, and that of what a fault changes.
Networks networks_of(std::int64_t samples, std::int64_t classes,
                     const std::vector<DenoiserSize>& sizes);

/// Write and read a model without its weights. Reading throws artefact::Refusal for a path that is
/// not known, and for sizes, steps or a guidance outside their ranges.
void write(artefact::Writer& writer, const DiffusionModel& model);
DiffusionModel read_diffusion_model(const artefact::Reader& reader);

/// Follows the path from noise [n, N] at u = 1 to windows [n, N] of a class, in equal steps of u,
/// by the velocities of the back end: for `diffusion` by steps of DDIM, for `flow` by the midpoint
/// rule, which asks for two velocities in each step.
std::vector<float> follow(const DiffusionModel& model, DiffusionBackend& backend, Label label,
                          std::vector<float> noise);

/// Makes `count` windows of each class with a defect from a stored model, in the recordings' unit.
/// The noise of a window comes from its own random numbers (signal/made_windows.hpp). Throws
/// artefact::Refusal as read_diffusion_model(), and for missing or damaged weights.
signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                           MakeDiffusionBackend make_backend, Device device);

}  // namespace piae::diffusion
