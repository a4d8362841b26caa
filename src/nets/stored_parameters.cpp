#include "nets/stored_parameters.hpp"

namespace piae::nets {

void write_parameters(artefact::Writer& writer, const std::string& group,
                      const std::vector<ParameterSpec>& specs, std::span<const float> values) {
  for (const ParameterSpec& spec : specs) {
    const auto size = static_cast<std::size_t>(spec.size());
    writer.numbers(group + "/" + spec.name, values.first(size),
                   {spec.shape.begin(), spec.shape.end()});
    values = values.subspan(size);
  }
}

std::vector<float> read_parameters(const artefact::Reader& reader, const std::string& group,
                                   const std::vector<ParameterSpec>& specs) {
  std::vector<float> values;
  for (const ParameterSpec& spec : specs) {
    const artefact::hdf5::Shape shape(spec.shape.begin(), spec.shape.end());
    const std::vector<float> own = reader.numbers<float>(group + "/" + spec.name, shape).values;
    values.insert(values.end(), own.begin(), own.end());
  }
  return values;
}

void write(artefact::Writer& writer, const std::string& group, const AdamState& state) {
  writer.numbers(group + "/first_moment", state.first_moment);
  writer.numbers(group + "/second_moment", state.second_moment);
  writer.attribute(group, "steps", state.steps);
}

AdamState read_adam_state(const artefact::Reader& reader, const std::string& group,
                          std::size_t size) {
  return {.first_moment = reader.numbers<float>(group + "/first_moment", {size}).values,
          .second_moment = reader.numbers<float>(group + "/second_moment", {size}).values,
          .steps = reader.integer(group, "steps")};
}

}  // namespace piae::nets
