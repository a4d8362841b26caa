#pragma once

#include <string>

namespace piae::diagnosis {

/// Whether LibTorch is what `--backend` asks for with the device of `--device`: "native" is for the
/// cpu alone, "libtorch" for cpu and cuda, and "auto" is native where it can be. Throws
/// Error(usage) for another word, and for native with another device.
bool needs_libtorch(const std::string& backend, const std::string& device);

}  // namespace piae::diagnosis
