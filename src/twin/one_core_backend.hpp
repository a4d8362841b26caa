#pragma once

#include "twin/backend.hpp"

namespace piae::twin {

/// Returns our own engine, which runs on one core and has hand-written gradients (losses.hpp,
/// nets/network.hpp). The device is always the CPU (base/compute.hpp refuses others).
Engine one_core_engine(Device device);

}  // namespace piae::twin
