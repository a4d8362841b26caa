#pragma once

#include "diagnosis/wdcnn_backend.hpp"
#include "latent/generator.hpp"
#include "latent/vae.hpp"
#include "latent/wgan_gp.hpp"
#include "twin/backend.hpp"

// The one way from the rest of the project to LibTorch. LibTorch takes 0.4 s and 160 MB at each
// start and need not be installed, so a program is linked either with it (back_ends.cpp of the room
// libtorch) or without (absent.cpp beside this file). Nothing else in the source differs.
namespace piae::seam {

/// All that LibTorch computes, each on the device that is asked for.
struct BackEnds {
  twin::MakeEngine twin;
  latent::MakeVae vae;
  latent::MakeWganGp wgan_gp;
  latent::OpenGenerator generator;
  diagnosis::MakeWdcnnBackend (*wdcnn)(Device device);
};

/// Null in a program that is linked without LibTorch.
const BackEnds* back_ends();

/// One of its back ends, or null in a program that is linked without LibTorch.
template <class F>
F back_end(F BackEnds::*which) {
  const BackEnds* const all = back_ends();
  return all == nullptr ? nullptr : all->*which;
}

/// Does nothing in a program that is linked with LibTorch. A program that is not is replaced by the
/// one that is: it lies in the same folder, is called <program>-libtorch, and gets the same
/// arguments. The function does not return then. Throws Error(failed) where there is no such
/// program, as after a build with LIBTORCH=off.
void continue_with_libtorch(char** argv);

/// The back end of a WDCNN: ours, or LibTorch's where that is asked for. Continues with LibTorch,
/// and throws, as above.
diagnosis::MakeWdcnnBackend wdcnn_backend(const Compute& compute, char** argv);

}  // namespace piae::seam
