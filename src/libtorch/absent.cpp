// This is linked into the programs that do without LibTorch.

#include "libtorch/back_ends.hpp"

namespace piae::libtorch {

const BackEnds* back_ends() { return nullptr; }

}  // namespace piae::libtorch
