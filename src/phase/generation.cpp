#include "phase/generation.hpp"

#include <algorithm>

#include "nets/device.hpp"
#include "nets/torch.hpp"
#include "phase/states.hpp"
#include "twin/inputs.hpp"
#include "twin/model.hpp"
#include "twin/networks.hpp"
#include "twin/physics.hpp"
#include "twin/space.hpp"

namespace piae::phase {

namespace {

/// What a stored model knows of its twin space.
struct Known {
  std::vector<twin::TwinPoint> points;
  std::vector<std::int32_t> labels;
  int bins = 0;

  explicit Known(const artefact::Reader& model)
      : points(twin::TwinSpace(model).points()),
        labels(model.numbers<std::int32_t>("/phase/labels", {points.size()}).values),
        bins(static_cast<int>(model.integer("/phase", "space_bins"))) {}

  /// The space of one class alone: the state of an inner race says nothing about a ball.
  [[nodiscard]] twin::TwinSpace space_of(std::size_t label) const {
    std::vector<twin::TwinPoint> own;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (static_cast<std::size_t>(labels[i]) == label) own.push_back(points[i]);
    }
    return {own, bins};
  }
};

/// What is drawn for one window.
struct Draw {
  twin::TwinPoint first;
  twin::TwinPoint second;
  Passage passage;
};

std::vector<Draw> draw(const twin::TwinSpace& space, const Cycle& cycle, std::size_t length,
                       std::size_t count, const Stream& stream) {
  std::vector<Draw> draws;
  for (std::size_t i = 0; i < count; ++i) {
    Stream own = stream.child(std::to_string(i));
    const twin::TwinPoint first = space.sample(own);
    const twin::TwinPoint second = space.sample(own);
    draws.push_back({first, second, draw_passage(cycle, length, own)});
  }
  return draws;
}

/// Decoder inputs of all first states, then all second ones.
std::vector<twin::TwinPoint> decoder_inputs(const std::vector<Draw>& draws, const StateScale& scale,
                                            std::size_t label) {
  std::vector<twin::TwinPoint> inputs;
  for (const auto state : {&Draw::first, &Draw::second}) {
    for (const Draw& d : draws) inputs.push_back(scale.standardised(d.*state, label));
  }
  return inputs;
}

}  // namespace

Passage draw_passage(const Cycle& cycle, std::size_t length, Stream& stream) {
  return {stream.below(cycle.samples), stream.below(length), stream.below(cycle.strikes)};
}

std::vector<float> pass(std::span<const float> first, std::span<const float> second,
                        const Cycle& cycle, const Passage& passage, std::size_t length) {
  std::vector<float> window = read(first, passage.start, passage.change);
  const std::size_t ahead = passage.start + passage.change + cycle.offset_of_strike(passage.turn);
  const std::vector<float> rest = read(second, ahead, length - passage.change);
  window.insert(window.end(), rest.begin(), rest.end());
  return window;
}

signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                           const std::string& device_name) {
  const torch::NoGradGuard no_grad;
  const torch::Device device = nets::prepare_device(device_name);
  const twin::ModelDescription description = twin::read_model_description(model);
  const signal::DatasetInfo& info = description.info;
  const twin::Networks networks(twin::without_encoder, description.shape, description.options);
  nets::ParameterSet parameters(networks.specs(), stream, torch::kFloat32, device);
  parameters.read(model, "/" + description.options.keep);
  const Known known(model);
  const StateScale scale(known.points, known.labels, info.classes.size());

  signal::WindowSet generated;
  generated.info = info;
  generated.length = static_cast<std::size_t>(description.shape.samples);
  for (std::size_t label = 0; label < info.classes.size(); ++label) {
    if (info.classes[label].defect == signal::Defect::none) continue;
    const Cycle cycle = cycle_of(info, label, generated.length);
    const std::vector<Draw> draws = draw(known.space_of(label), cycle, generated.length, count,
                                         stream.child(info.classes[label].name));
    const std::vector<float> waveforms = nets::to_vector(
        networks.decode(parameters, twin::as_tensor(decoder_inputs(draws, scale, label), device),
                        twin::one_hot_of(label, description.shape.classes, 2 * count, device)) *
        description.acceleration[label]);
    const auto waveform = [&](std::size_t row) {
      return std::span(waveforms).subspan(row * generated.length, cycle.samples);
    };
    for (std::size_t i = 0; i < count; ++i) {
      const std::vector<float> window =
          pass(waveform(i), waveform(count + i), cycle, draws[i].passage, generated.length);
      generated.samples.insert(generated.samples.end(), window.begin(), window.end());
      generated.labels.push_back(static_cast<std::int32_t>(label));
      generated.parameters.push_back(twin::in_units(draws[i].first));
    }
  }
  return generated;
}

}  // namespace piae::phase
