#include "twin/model.hpp"

#include "nets/ranges.hpp"
#include "signal/amplitude.hpp"
#include "signal/ranges.hpp"

namespace piae::twin {

namespace {

Keep read_keep(const artefact::Reader& reader) {
  const std::string word = reader.text("/", "keep");
  for (const Keep keep : {Keep::best, Keep::final}) {
    if (word == to_string(keep)) return keep;
  }
  reader.refuse("keep", "is '" + word + "'; known: best, final");
}

/// Models without this attribute are older than the option and use softplus.
Positive read_positive(const artefact::Reader& reader) {
  if (!reader.has_attribute("/", "positive")) return Positive::softplus;
  const std::string word = reader.text("/", "positive");
  for (const Positive positive : {Positive::softplus, Positive::exponential}) {
    if (word == to_string(positive)) return positive;
  }
  reader.refuse("positive", "is '" + word + "'; known: softplus, exponential");
}

}  // namespace

void write(artefact::Writer& writer, const ModelDescription& description) {
  signal::write(writer, description.info);
  writer.attribute("/", "samples", description.shape.samples);
  writer.attribute("/", "depth", std::int64_t{description.options.depth});
  writer.attribute("/", "width", std::int64_t{description.options.width});
  writer.attribute("/", "keep", std::string(to_string(description.options.keep)));
  writer.attribute("/", "positive", std::string(to_string(description.options.positive)));
  writer.numbers("/classes/acceleration", description.acceleration);
}

ModelDescription read_model_description(const artefact::Reader& reader) {
  ModelDescription description;
  description.info = signal::read_dataset_info(reader);
  const std::size_t classes = description.info.classes.size();
  description.shape = {.samples = reader.integer("/", "samples", signal::ranges::window_samples),
                       .classes = static_cast<std::int64_t>(classes)};
  description.options.depth = static_cast<int>(reader.integer("/", "depth", nets::ranges::depth));
  description.options.width = static_cast<int>(reader.integer("/", "width", nets::ranges::width));
  description.options.keep = read_keep(reader);
  description.options.positive = read_positive(reader);
  description.acceleration =
      signal::read_amplitudes(reader, "/classes/acceleration", description.info);
  return description;
}

}  // namespace piae::twin
