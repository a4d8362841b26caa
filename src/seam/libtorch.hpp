#pragma once

#include "diagnosis/wdcnn_backend.hpp"
#include "diffusion/backend.hpp"
#include "latent/generator.hpp"
#include "latent/vae.hpp"
#include "latent/wgan_gp.hpp"
#include "twin/backend.hpp"

// The only way from the rest of the project to LibTorch. LibTorch costs 0.4 s and 160 MB at each
// start and may not be installed. So a program is linked either with it (back_ends.cpp of the room
// libtorch) or without it (absent.cpp in this folder). Nothing else in the source differs.
namespace piae::seam {

/// Everything that LibTorch computes, each on the requested device.
struct BackEnds {
  twin::MakeEngine twin;
  latent::MakeVae vae;
  latent::MakeWganGp wgan_gp;
  latent::OpenGenerator generator;
  diffusion::MakeDiffusionBackend diffusion;
  diagnosis::MakeWdcnnBackend (*wdcnn)(Device device);
};

/// Returns the back ends, or null in a program that is linked without LibTorch.
const BackEnds* back_ends();

/// Returns one of the back ends, or null in a program that is linked without LibTorch.
template <class F>
F back_end(F BackEnds::*which) {
  const BackEnds* const all = back_ends();
  return all == nullptr ? nullptr : all->*which;
}

/// Does nothing in a program that is linked with LibTorch. Otherwise replaces the process by the
/// program <program>-libtorch of the same folder, with the same arguments, and does not return.
/// Throws Error(failed) if that program does not exist, as after a build with LIBTORCH=off.
void continue_with_libtorch(char** argv);

/// Returns the back end of a WDCNN: ours, or LibTorch's if `compute` requires it. Then continues
/// with LibTorch, and throws, like continue_with_libtorch().
diagnosis::MakeWdcnnBackend wdcnn_backend(const Compute& compute, char** argv);

}  // namespace piae::seam
