#pragma once

#include "base/error.hpp"

namespace piae {

/// What computes neural networks: the option `--backend`.
enum class Backend {
  automatic,  ///< our own where it can, else LibTorch
  native,     ///< our own, on one core
  libtorch,   ///< LibTorch, on the cpu or on cuda
};

/// What they are computed on: the option `--device`.
enum class Device { cpu, cuda };

struct Compute {
  Backend backend = Backend::automatic;
  Device device = Device::cpu;
};

/// Whether LibTorch must compute these networks. `has_native` says whether our own back end can.
/// Throws Error(usage) where our own is asked for and cannot.
bool needs_libtorch(const Compute& compute, bool has_native = true);

/// The same thing by each back end. Null where there is none: a program that is not linked with
/// LibTorch has nothing of LibTorch's.
template <class F>
struct Backends {
  F native;
  F libtorch;

  [[nodiscard]] bool needs_libtorch(const Compute& compute) const {
    return piae::needs_libtorch(compute, native != nullptr);
  }
  /// Throws Error(failed) for LibTorch's in a program that is not linked with it.
  [[nodiscard]] F chosen(const Compute& compute) const {
    if (!needs_libtorch(compute)) return native;
    if (libtorch == nullptr) throw Error(Exit::failed, "this program is not linked with LibTorch");
    return libtorch;
  }
};

}  // namespace piae
