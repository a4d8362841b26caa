#include "diffusion/model.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/parallel.hpp"
#include "base/vector.hpp"
#include "diffusion/ranges.hpp"
#include "nets/ranges.hpp"
#include "nets/stored_parameters.hpp"
#include "signal/amplitude.hpp"
#include "signal/made_windows.hpp"
#include "signal/ranges.hpp"

namespace piae::diffusion {

namespace {

constexpr std::size_t windows_at_once = 32;

/// Names of the networks in the order of Networks.
const std::array<std::string, 2> names{"net/denoiser", "net/change"};

struct NamedPath {
  const char* name;
  Path path;
};
constexpr NamedPath paths[] = {{"diffusion", Path::diffusion}, {"flow", Path::flow}};

Path read_path(const artefact::Reader& reader) {
  const std::string name = reader.text("/", "path");
  for (const NamedPath& each : paths) {
    if (name == each.name) return each.path;
  }
  reader.refuse("/", fmt::format("path is '{}', but diffusion and flow are known", name));
}

std::vector<DenoiserSize> read_sizes(const artefact::Reader& reader) {
  const auto channels = reader.numbers<std::int64_t>("/networks/channels", {0}).values;
  const auto blocks = reader.numbers<std::int64_t>("/networks/blocks", {channels.size()}).values;
  if (channels.empty() || channels.size() > names.size()) {
    reader.refuse("/networks/channels",
                  fmt::format("has {} networks, not 1 or 2", channels.size()));
  }
  reader.require_all("/networks/channels", channels, nets::ranges::width);
  reader.require_all("/networks/blocks", blocks, nets::ranges::depth);
  std::vector<DenoiserSize> sizes;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (channels[i] % row_granule != 0) {
      reader.refuse("/networks/channels", fmt::format("holds {}, which is not a multiple of {}",
                                                      channels[i], row_granule));
    }
    sizes.push_back(
        {.channels = static_cast<int>(channels[i]), .blocks = static_cast<int>(blocks[i])});
  }
  return sizes;
}

/// Returns v(class) + w (v(class) - v(no class)) for windows x [n, N] at u.
std::vector<float> guided_velocity(const DiffusionModel& model, DiffusionBackend& backend,
                                   Label label, const std::vector<float>& x, double u) {
  const std::size_t n = x.size() / static_cast<std::size_t>(model.samples());
  NoisyBatch batch{.windows = x,
                   .u = std::vector<double>(n, u),
                   .labels = std::vector<std::optional<Label>>(n, label)};
  std::vector<float> velocity = backend.velocities(batch, model.networks.size());
  if (model.guidance > 0) {
    const auto guidance = static_cast<float>(model.guidance);
    batch.labels.assign(n, std::nullopt);
    const std::vector<float> untold = backend.velocities(batch, model.networks.size());
    for (std::size_t i = 0; i < velocity.size(); ++i) {
      velocity[i] += guidance * (velocity[i] - untold[i]);
    }
  }
  return velocity;
}

std::vector<float> moved(const std::vector<float>& x, const std::vector<float>& velocity,
                         const Move& move) {
  std::vector<float> there(x.size());
  std::ranges::transform(x, velocity, there.begin(), [&](float at, float v) {
    return static_cast<float>(move.of_x) * at + static_cast<float>(move.of_velocity) * v;
  });
  return there;
}

}  // namespace

Networks networks_of(std::int64_t samples, std::int64_t classes,
                     const std::vector<DenoiserSize>& sizes) {
  Networks networks;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const bool healthy = i + 1 < sizes.size();
    networks.push_back({.name = names.at(i),
                        .samples = samples,
                        .classes = healthy ? 0 : classes,
                        .size = sizes[i]});
  }
  return networks;
}

void write(artefact::Writer& writer, const DiffusionModel& model) {
  signal::write(writer, model.info);
  writer.attribute("/", "path", std::string(paths[static_cast<std::size_t>(model.path)].name));
  writer.attribute("/", "samples", model.samples());
  writer.attribute("/", "steps", std::int64_t{model.steps});
  writer.attribute("/", "guidance", model.guidance);
  writer.numbers("/classes/rms", model.rms);
  std::vector<std::int64_t> channels;
  std::vector<std::int64_t> blocks;
  for (const Denoiser& network : model.networks) {
    channels.push_back(network.size.channels);
    blocks.push_back(network.size.blocks);
  }
  writer.numbers("/networks/channels", channels);
  writer.numbers("/networks/blocks", blocks);
}

DiffusionModel read_diffusion_model(const artefact::Reader& reader) {
  DiffusionModel model;
  model.info = signal::read_dataset_info(reader);
  model.path = read_path(reader);
  model.steps = static_cast<int>(reader.integer("/", "steps", ranges::steps));
  model.guidance = reader.real("/", "guidance", ranges::guidance);
  model.rms = signal::read_amplitudes(reader, "/classes/rms", model.info);
  model.networks = networks_of(reader.integer("/", "samples", signal::ranges::window_samples),
                               std::ssize(model.info.classes), read_sizes(reader));
  if (model.samples() % Denoiser::frame != 0) {
    reader.refuse("/", fmt::format("samples is {}, not whole frames of {}", model.samples(),
                                   Denoiser::frame));
  }
  return model;
}

std::vector<float> follow(const DiffusionModel& model, DiffusionBackend& backend, Label label,
                          std::vector<float> noise) {
  std::vector<float> x = std::move(noise);
  for (int step = model.steps; step > 0; --step) {
    const double here = static_cast<double>(step) / model.steps;
    const double next = static_cast<double>(step - 1) / model.steps;
    std::vector<float> velocity = guided_velocity(model, backend, label, x, here);
    if (model.path == Path::flow) {
      const double middle = (here + next) / 2;
      const std::vector<float> x_middle =
          moved(x, velocity, move_between(model.path, here, middle));
      velocity = guided_velocity(model, backend, label, x_middle, middle);
    }
    x = moved(x, velocity, move_between(model.path, here, next));
  }
  return x;
}

signal::WindowSet generate(const artefact::Reader& stored, std::size_t count, const Stream& stream,
                           MakeDiffusionBackend make_backend, Device device) {
  const DiffusionModel model = read_diffusion_model(stored);
  const auto length = static_cast<std::size_t>(model.samples());
  const std::vector<float> weights =
      nets::read_parameters(stored, weights_group, specs_of(model.networks));
  signal::WindowSet windows = signal::make_windows(model.info, length, count, stream,
                                                   [&](Label, std::size_t, Stream& random) {
                                                     std::vector<float> noise(length);
                                                     for (float& e : noise)
                                                       e = static_cast<float>(random.normal(0, 1));
                                                     return noise;
                                                   });
  const std::size_t classes = count == 0 ? 0 : windows.size() / count;
  parallel_for_parts(classes, count, windows_at_once, [&](std::size_t first, std::size_t part) {
    const auto backend = make_backend(model.networks, windows_at_once, Stream("replaced"), device);
    backend->set_values(weights);
    const auto from = windows.samples.begin() + static_cast<std::ptrdiff_t>(first * length);
    const auto to = from + static_cast<std::ptrdiff_t>(part * length);
    const Label label = windows.labels[first];
    const std::vector<float> made = follow(model, *backend, label, {from, to});
    const auto rms = static_cast<float>(model.rms[index_of(label)]);
    std::ranges::transform(made, from, [&](float x) { return rms * x; });
  });
  return windows;
}

}  // namespace piae::diffusion
