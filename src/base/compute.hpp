#pragma once

#include "base/error.hpp"

namespace piae {

/// What computes neural networks: `--backend`.
enum class Backend {
  automatic,  ///< native where it can be, else LibTorch
  native,     ///< ours, for one core
  libtorch,   ///< LibTorch, for the cpu and for cuda
};

/// Where: `--device`.
enum class Device { cpu, cuda };

struct Compute {
  Backend backend = Backend::automatic;
  Device device = Device::cpu;
};

/// Whether LibTorch is what is asked for, of networks that our own back end can compute or cannot.
/// Throws Error(usage) where our own is asked for and cannot do it.
bool needs_libtorch(const Compute& compute, bool has_native = true);

/// The same thing by each back end. Null where there is none: ours has no convolutional twin, and
/// a program that is not linked with LibTorch has nothing of LibTorch's.
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
