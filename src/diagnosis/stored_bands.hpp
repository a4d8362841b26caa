#pragma once

#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/label.hpp"
#include "diagnosis/band_powers.hpp"
#include "signal/dataset_info.hpp"

namespace piae::diagnosis {

/// Writes band powers of windows and their labels, as <group>/bands float64 [n, 128] and
/// <group>/labels.
void write_bands(artefact::Writer& writer, const std::string& group, const BandPowers& bands,
                 const std::vector<Label>& labels);

/// Throws artefact::Refusal if labels are missing, or a label has no class.
std::vector<Label> read_labels(const artefact::Reader& reader, const std::string& group,
                               const signal::DatasetInfo& info);
/// Throws artefact::Refusal for another shape.
BandPowers read_bands(const artefact::Reader& reader, const std::string& group, std::size_t n);

}  // namespace piae::diagnosis
