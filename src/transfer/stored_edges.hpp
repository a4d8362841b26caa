#pragma once

#include <cstddef>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "transfer/edges.hpp"

namespace piae::transfer {

/// In the artefact, of each known window: /edges/lag_s, /edges/exit and /edges/spread, float64 [n].
void write(artefact::Writer& writer, const std::vector<Edges>& edges);
/// Throws artefact::Refusal for another number of windows, and for edges that cannot be.
std::vector<Edges> read_edges(const artefact::Reader& reader, std::size_t windows);

}  // namespace piae::transfer
