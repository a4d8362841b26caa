// Linked into programs with LibTorch.

#include "libtorch/diffusion/backend.hpp"
#include "libtorch/latent/backends.hpp"
#include "libtorch/twin/backend.hpp"
#include "libtorch/wdcnn/backend.hpp"
#include "seam/libtorch.hpp"

namespace piae::seam {

const BackEnds* back_ends() {
  static constexpr BackEnds all{.twin = libtorch::twin_engine,
                                .vae = libtorch::vae,
                                .wgan_gp = libtorch::wgan_gp,
                                .generator = libtorch::open_generator,
                                .diffusion = libtorch::diffusion_backend,
                                .wdcnn = libtorch::wdcnn_on};
  return &all;
}

}  // namespace piae::seam
