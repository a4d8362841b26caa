#pragma once

#include "twin/backend.hpp"

namespace piae::twin {

/// Ours, for one core and for dense encoders and decoders, with gradients written by hand
/// (losses.hpp, nets/dense_chain.hpp).
Engine dense_engine(Device device);

}  // namespace piae::twin
