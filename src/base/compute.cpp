#include "base/compute.hpp"

namespace piae {

bool needs_libtorch(const Compute& compute, bool has_native) {
  switch (compute.backend) {
    case Backend::libtorch:
      return true;
    case Backend::automatic:
      return compute.device != Device::cpu || !has_native;
    case Backend::native:
      break;
  }
  if (compute.device != Device::cpu) {
    throw Error(Exit::usage, "--backend: native computes on the cpu, not on cuda; use libtorch");
  }
  if (!has_native) {
    throw Error(Exit::usage, "--backend: these networks have no native back end; use libtorch");
  }
  return false;
}

}  // namespace piae
