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

}  // namespace piae::nets
