#pragma once

#include <cstddef>

#include "artefact/reader.hpp"
#include "base/compute.hpp"
#include "base/random.hpp"
#include "signal/window_set.hpp"
#include "twin/backend.hpp"

namespace piae::augment {

/// The networks of twins by what is asked for. Throws as Backends::chosen() does.
twin::Engine twin_engine(const Compute& compute);

/// Makes windows with a stored VAE or WGAN-GP (latent/generator.hpp) by the back end that is asked
/// for.
signal::WindowSet generate_from_latent(const artefact::Reader& model, std::size_t count,
                                       const Stream& stream, const Compute& compute);

}  // namespace piae::augment
