#pragma once

#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "signal/window_set.hpp"
#include "transfer/edge_fit.hpp"

namespace piae::transfer {

/// The edges of the defect in each known window, in the order of the windows. Windows of one class,
/// speed and size are of one bearing. Its spectrum is Welch's, of pieces of half a window that
/// overlap by three quarters; the band reaches from 2 % of half the sampling rate to the 91 % that
/// resampling leaves.
std::vector<impacts::Edges> edges_of_known(const signal::WindowSet& known, const EdgePrior& prior);

/// In the artefact, of each known window: /edges/lag_s, /edges/exit and /edges/spread, float64 [n].
void write(artefact::Writer& writer, const std::vector<impacts::Edges>& edges);
/// Throws artefact::Refusal for another number of windows, and for edges that cannot be.
std::vector<impacts::Edges> read_edges(const artefact::Reader& reader, std::size_t windows);

}  // namespace piae::transfer
