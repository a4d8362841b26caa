#pragma once

#include "twin/backend.hpp"

namespace piae::twin {

/// Our own back end. It runs on one core, knows dense encoders and decoders only, and has its
/// gradients written by hand (losses.hpp, nets/dense_chain.hpp). The device is always the CPU
/// (base/compute.hpp refuses others).
Engine dense_engine(Device device);

}  // namespace piae::twin
