#pragma once

#include <span>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "nets/parameter_spec.hpp"

namespace piae::nets {

/// Writes parameters, one after the other in `values`, as datasets <group>/<name>, float32, with
/// the shapes of the specs.
void write_parameters(artefact::Writer& writer, const std::string& group,
                      const std::vector<ParameterSpec>& specs, std::span<const float> values);

/// Throws artefact::Refusal when a parameter is missing or has another shape.
std::vector<float> read_parameters(const artefact::Reader& reader, const std::string& group,
                                   const std::vector<ParameterSpec>& specs);

}  // namespace piae::nets
