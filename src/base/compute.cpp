#include "base/compute.hpp"

#include "base/error.hpp"

namespace piae {

void require_known_device(const std::string& device) {
  if (device == "cpu" || device == "cuda") return;
  throw Error(Exit::usage, "--device: unknown device '" + device + "'; known are cpu and cuda");
}

bool needs_libtorch(const Compute& compute, bool has_native) {
  require_known_device(compute.device);
  if (compute.backend == "libtorch") return true;
  if (compute.backend == "auto") return compute.device != "cpu" || !has_native;
  if (compute.backend != "native") {
    throw Error(Exit::usage, "--backend: unknown back end '" + compute.backend +
                                 "'; known are auto, native and libtorch");
  }
  if (compute.device != "cpu") {
    throw Error(Exit::usage, "--backend: native computes on the cpu, not on " + compute.device +
                                 "; use libtorch");
  }
  if (!has_native) {
    throw Error(Exit::usage, "--backend: these networks have no native back end; use libtorch");
  }
  return false;
}

}  // namespace piae
