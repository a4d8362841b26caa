#include "twin/generation.hpp"

#include "base/label.hpp"
#include "twin/model.hpp"
#include "twin/physics.hpp"
#include "twin/space.hpp"

namespace piae::twin {

namespace {

std::vector<TwinPoint> draw(const TwinSpace& space, std::size_t count, const Stream& stream) {
  std::vector<TwinPoint> points;
  for (std::size_t i = 0; i < count; ++i) {
    Stream own = stream.child(std::to_string(i));
    points.push_back(space.sample(own));
  }
  return points;
}

}  // namespace

signal::WindowSet generate(const artefact::Reader& model, const TwinVariant& variant,
                           std::size_t count, const Stream& stream, const Engine& engine) {
  const ModelDescription description = read_model_description(model);
  const ClassSpaces spaces(model);
  const std::unique_ptr<StoredTwin> networks = engine.open(model, description, variant);
  signal::WindowSet generated;
  generated.info = description.info;
  generated.length = static_cast<std::size_t>(description.shape.samples);
  for (Label label = 0; index_of(label) < description.info.classes.size(); ++label) {
    const signal::ClassInfo& c = description.info.classes[index_of(label)];
    if (c.defect == signal::Defect::none) continue;
    const std::vector<TwinPoint> points = draw(spaces.of(label), count, stream.child(c.name));
    for (const float a : networks->decode(points, label)) {
      generated.samples.push_back(a *
                                  static_cast<float>(description.acceleration[index_of(label)]));
    }
    generated.labels.insert(generated.labels.end(), count, label);
    for (const TwinPoint& point : points) generated.parameters.push_back(in_units(point));
  }
  return generated;
}

}  // namespace piae::twin
