#pragma once

#include <memory>

#include "base/compute.hpp"
#include "latent/backend.hpp"

namespace piae::latent {

/// Makes a back end of the conditional VAE, which minimises the negative evidence bound over all
/// parameters (Kingma and Welling 2014). A step returns the two parts of the bound, each a sum over
/// one window, averaged over the batch:
///  - squared error, 1/2 |x - x^|^2: x^ is the decoded window, around which the data are Gaussian
/// with variance 1;
///  - KL divergence, KL(q(z|x) || N(0, 1)).
/// The back end owns the task; initial values come from `initial`.
using MakeVae = std::unique_ptr<LatentBackend> (*)(LatentTask task, const Stream& initial,
                                                   Device device);

/// Our own back end, for one core.
std::unique_ptr<LatentBackend> vae(LatentTask task, const Stream& initial, Device device);

}  // namespace piae::latent
