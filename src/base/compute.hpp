#pragma once

#include "base/error.hpp"

namespace piae {

/// Back end of the neural networks: the option `--backend`.
enum class Backend {
  automatic,  ///< native on the cpu, LibTorch on cuda
  native,     ///< this project's own, on one core
  libtorch,   ///< LibTorch, on the cpu or on cuda
};

/// Device of the neural networks: the option `--device`.
enum class Device { cpu, cuda };

struct Compute {
  Backend backend = Backend::automatic;
  Device device = Device::cpu;
};

/// True if LibTorch must compute the networks. Throws Error(usage) if the native back end is
/// requested for a device that it does not support.
bool needs_libtorch(const Compute& compute);

/// One implementation by each back end. LibTorch's is null in a program that is not linked with it.
template <class F>
struct Backends {
  F native;
  F libtorch;

  /// Throws Error(failed) if LibTorch is chosen in a program that is not linked with it.
  [[nodiscard]] F chosen(const Compute& compute) const {
    if (!needs_libtorch(compute)) return native;
    if (libtorch == nullptr) throw Error(Exit::failed, "this program is not linked with LibTorch");
    return libtorch;
  }
};

}  // namespace piae
