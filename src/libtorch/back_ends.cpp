// This is linked into the programs that have LibTorch.

#include "libtorch/back_ends.hpp"

#include "libtorch/latent/backends.hpp"
#include "libtorch/twin/backend.hpp"
#include "libtorch/wdcnn/backend.hpp"

namespace piae::libtorch {

const BackEnds* back_ends() {
  static constexpr BackEnds all{.twin = twin_engine,
                                .vae = vae,
                                .wgan_gp = wgan_gp,
                                .generator = open_generator,
                                .wdcnn = wdcnn_on};
  return &all;
}

}  // namespace piae::libtorch
