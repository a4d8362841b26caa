#pragma once

#include "twin/backend.hpp"

namespace piae::twin {

/// Our own back end. It runs on one core and has its gradients written by hand (losses.hpp,
/// nets/network.hpp). The device is always the CPU (base/compute.hpp refuses others).
Engine one_core_engine(Device device);

}  // namespace piae::twin
