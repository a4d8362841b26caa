#pragma once

#include <string>

namespace piae {

/// What computes neural networks: `--backend` and `--device`.
struct Compute {
  /// "native", ours for one core; "libtorch", for cpu and cuda; "auto", native where it can be.
  std::string backend = "auto";
  std::string device = "cpu";  ///< or "cuda"
};

/// Throws Error(usage) for another word than cpu or cuda.
void require_known_device(const std::string& device);

/// Whether LibTorch is what is asked for, of something that has a native back end or has none.
/// Throws Error(usage) for other words, and where native is asked for and cannot be.
bool needs_libtorch(const Compute& compute, bool has_native = true);

/// The same thing by each back end; null where there is none, as LibTorch's in a program without
/// it.
template <class F>
struct Backends {
  F native;
  F libtorch;

  [[nodiscard]] bool needs_libtorch(const Compute& compute) const {
    return piae::needs_libtorch(compute, native != nullptr);
  }
  [[nodiscard]] F chosen(const Compute& compute) const {
    return needs_libtorch(compute) ? libtorch : native;
  }
};

}  // namespace piae
