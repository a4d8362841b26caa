#pragma once

#include <string>

#include "formats/exported.hpp"

namespace piae::formats {

/// Returns a NumPy file (format 1.0): the samples as float32 [n, length].
std::string npy(const signal::WindowSet& windows);

}  // namespace piae::formats
