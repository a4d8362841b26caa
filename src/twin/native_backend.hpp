#pragma once

#include <string>

#include "twin/backend.hpp"

namespace piae::twin {

/// Ours, for one core and for dense encoders and decoders: the mathematics of libtorch_backend.hpp
/// with gradients written by hand (native_losses.hpp, nets/dense_chain.hpp). Throws
/// Error(usage) for a device other than "cpu".
Engine native_engine(const std::string& device);

}  // namespace piae::twin
