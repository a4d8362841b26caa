#include "phase/generation.hpp"

#include <algorithm>

#include "phase/class_cycle.hpp"
#include "phase/states.hpp"
#include "twin/model.hpp"
#include "twin/physics.hpp"
#include "twin/ranges.hpp"
#include "twin/space.hpp"

namespace piae::phase {

namespace {

/// Returns the classes of the known windows from which these points were inferred.
std::vector<Label> read_labels(const artefact::Reader& model,
                               const std::vector<twin::TwinPoint>& points) {
  const std::string path = "/phase/labels";
  std::vector<Label> labels = model.numbers<Label>(path, {points.size()}).values;
  twin::require_points_of_faults(model, path, labels);
  for (const twin::TwinPoint& point : points) {
    const Range& range = twin::ranges::positive_coordinate;
    if (!range.holds(point.k) || !range.holds(point.c)) {
      model.refuse("/twin_space/points", "holds a stiffness or a damping that is not positive");
    }
  }
  return labels;
}

/// The decoder of a stored model and its twin space.
class Decoder {
 public:
  Decoder(const artefact::Reader& model, const twin::Engine& engine)
      : description_(twin::read_model_description(model)),
        networks_(engine.open(model, description_, twin::without_encoder)),
        points_(twin::TwinSpace(model).points()),
        labels_(read_labels(model, points_)),
        bins_(static_cast<int>(model.integer("/phase", "space_bins", twin::ranges::bins))),
        scale_(points_, labels_, info().classes.size()) {}

  [[nodiscard]] const signal::DatasetInfo& info() const { return description_.info; }
  [[nodiscard]] std::size_t length() const {
    return static_cast<std::size_t>(description_.shape.samples);
  }
  [[nodiscard]] signal::Cycle cycle(Label label) const {
    return cycle_of_class(info(), label, length());
  }

  /// Returns the twin space of one class. Each class has its own, because the state of an inner
  /// race contains no information about a ball.
  [[nodiscard]] twin::TwinSpace space_of(Label label) const {
    return twin::space_of_class(points_, labels_, label, bins_);
  }

  [[nodiscard]] std::vector<float> windows(Label label, const std::vector<Draw>& draws) const {
    std::vector<float> waveforms = networks_->decode(inputs(draws, label), label);
    for (float& a : waveforms) {
      a *= static_cast<float>(description_.acceleration[index_of(label)]);
    }
    const signal::Cycle own = cycle(label);
    const auto waveform = [&](std::size_t row) {
      const std::span<const float> all_rows(waveforms);
      return signal::Waveform<float>{all_rows.subspan(row * length(), own.samples), own};
    };
    std::vector<float> all;
    for (std::size_t i = 0; i < draws.size(); ++i) {
      const std::vector<float> window =
          signal::splice(waveform(i), waveform(draws.size() + i), draws[i].passage, length());
      all.insert(all.end(), window.begin(), window.end());
    }
    return all;
  }

 private:
  /// Returns the decoder's inputs: all first states, then all second states.
  [[nodiscard]] std::vector<twin::TwinPoint> inputs(const std::vector<Draw>& draws,
                                                    Label label) const {
    std::vector<twin::TwinPoint> points;
    for (const auto state : {&Draw::first, &Draw::second}) {
      for (const Draw& d : draws) points.push_back(scale_.standardised(d.*state, label));
    }
    return points;
  }

  twin::ModelDescription description_;
  std::unique_ptr<twin::StoredTwin> networks_;
  std::vector<twin::TwinPoint> points_;  // states of the known windows
  std::vector<Label> labels_;            // classes of the known windows
  int bins_;
  StateScale scale_;
};

std::vector<Draw> draw(const twin::TwinSpace& space, const signal::Cycle& cycle, std::size_t length,
                       std::size_t count, const Stream& stream) {
  std::vector<Draw> draws;
  for (std::size_t i = 0; i < count; ++i) {
    Stream own = stream.child(std::to_string(i));
    const twin::TwinPoint first = space.sample(own);
    const twin::TwinPoint second = space.sample(own);
    draws.push_back(
        {.first = first, .second = second, .passage = signal::draw_passage(cycle, length, own)});
  }
  return draws;
}

}  // namespace

std::vector<float> decode(const artefact::Reader& model, Label label,
                          const std::vector<Draw>& draws, const twin::Engine& engine) {
  return Decoder(model, engine).windows(label, draws);
}

signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                           const twin::Engine& engine) {
  const Decoder decoder(model, engine);
  signal::WindowSet generated;
  generated.info = decoder.info();
  generated.length = decoder.length();
  for (Label label = 0; index_of(label) < generated.info.classes.size(); ++label) {
    const signal::ClassInfo& c = generated.info.classes[index_of(label)];
    if (c.defect == signal::Defect::none) continue;
    const std::vector<Draw> draws = draw(decoder.space_of(label), decoder.cycle(label),
                                         generated.length, count, stream.child(c.name));
    const std::vector<float> windows = decoder.windows(label, draws);
    generated.samples.insert(generated.samples.end(), windows.begin(), windows.end());
    for (const Draw& d : draws) {
      generated.labels.push_back(label);
      generated.parameters.push_back(twin::in_units(d.first));
      generated.start_angle_rad.push_back(decoder.cycle(label).angle_rad(d.passage.start));
    }
  }
  return generated;
}

}  // namespace piae::phase
