#pragma once

#include "base/error.hpp"

namespace piae {

/// What computes neural networks: the option `--backend`.
enum class Backend {
  automatic,  ///< our own on the cpu, LibTorch on cuda
  native,     ///< our own, on one core
  libtorch,   ///< LibTorch, on the cpu or on cuda
};

/// What they are computed on: the option `--device`.
enum class Device { cpu, cuda };

struct Compute {
  Backend backend = Backend::automatic;
  Device device = Device::cpu;
};

/// Whether LibTorch must compute networks. Throws Error(usage) where our own back end is asked for
/// and cannot.
bool needs_libtorch(const Compute& compute);

/// The same thing by each back end. LibTorch's is null in a program that is not linked with it.
template <class F>
struct Backends {
  F native;
  F libtorch;

  /// Throws Error(failed) for LibTorch's in a program that is not linked with it.
  [[nodiscard]] F chosen(const Compute& compute) const {
    if (!needs_libtorch(compute)) return native;
    if (libtorch == nullptr) throw Error(Exit::failed, "this program is not linked with LibTorch");
    return libtorch;
  }
};

}  // namespace piae
