#pragma once

#include <string>

#include "twin/backend.hpp"

namespace piae::twin {

/// LibTorch's eager operations on "cpu" or "cuda", for every variant.
Engine libtorch_engine(const std::string& device);

}  // namespace piae::twin
