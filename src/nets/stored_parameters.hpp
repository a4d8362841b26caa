#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "nets/parameter_spec.hpp"

namespace piae::nets {

/// Writes each parameter as a dataset <group>/<name>, float32, in the shape of its spec. `values`
/// holds all parameters, one after the other, in the order of the specs.
void write_parameters(artefact::Writer& writer, const std::string& group,
                      const std::vector<ParameterSpec>& specs, std::span<const float> values);

/// Reads the output of write_parameters(). Throws artefact::Refusal if a parameter is missing or
/// has another shape.
std::vector<float> read_parameters(const artefact::Reader& reader, const std::string& group,
                                   const std::vector<ParameterSpec>& specs);

/// State of Adam in addition to the parameters: both moments of each, and the step count.
struct AdamState {
  std::vector<float> first_moment;   ///< in the order of the parameters
  std::vector<float> second_moment;  ///< in the order of the parameters
  std::int64_t steps = 0;
};

/// Writes <group>/first_moment, <group>/second_moment and the attribute `steps` of the group.
void write(artefact::Writer& writer, const std::string& group, const AdamState& state);
/// Throws artefact::Refusal if a moment does not have `size` numbers.
AdamState read_adam_state(const artefact::Reader& reader, const std::string& group,
                          std::size_t size);

}  // namespace piae::nets
