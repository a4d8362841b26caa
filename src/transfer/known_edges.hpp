#pragma once

#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "signal/window_set.hpp"
#include "transfer/edge_fit.hpp"

namespace piae::transfer {

/// Returns the edges of the defect in each known window, in the order of the windows. Windows of
/// one class, speed and size belong to one bearing. Its spectrum is Welch's, over pieces of half a
/// window that overlap by three quarters. A defect of unknown size gets no edges: without its lag,
/// minima of the structure pass for those of the edges, and would move with the speed. The band
/// reaches from 2 % to 91 % of half the sampling rate, the part that resampling leaves.
std::vector<impacts::Edges> edges_of_known(const signal::WindowSet& known, const EdgePrior& prior);

/// Writes /edges/lag_s, /edges/exit and /edges/spread of each known window, float64 [n].
void write(artefact::Writer& writer, const std::vector<impacts::Edges>& edges);
/// Throws artefact::Refusal if the number of windows is wrong or if edges are impossible.
std::vector<impacts::Edges> read_edges(const artefact::Reader& reader, std::size_t windows);

}  // namespace piae::transfer
