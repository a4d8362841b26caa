#pragma once

#include <cstddef>

#include "artefact/reader.hpp"
#include "base/compute.hpp"
#include "base/random.hpp"
#include "signal/window_set.hpp"
#include "twin/backend.hpp"

namespace piae::augment {

/// Returns the engine for a twin's networks of the requested back end and device. Throws as
/// Backends::chosen() does.
twin::Engine twin_engine(const Compute& compute);

/// Makes windows with a stored VAE or WGAN-GP (latent/generator.hpp) on the requested back end.
signal::WindowSet generate_from_latent(const artefact::Reader& model, std::size_t count,
                                       const Stream& stream, const Compute& compute);

}  // namespace piae::augment
