#include "base/compute.hpp"

namespace piae {

bool needs_libtorch(const Compute& compute) {
  switch (compute.backend) {
    case Backend::libtorch:
      return true;
    case Backend::automatic:
      return compute.device != Device::cpu;
    case Backend::native:
      break;
  }
  if (compute.device != Device::cpu) {
    throw Error(Exit::usage, "--backend: native computes on the cpu, not on cuda; use libtorch");
  }
  return false;
}

}  // namespace piae
