// What a program is linked with that does without LibTorch.

#include "libtorch/back_ends.hpp"

namespace piae::libtorch {

const BackEnds* back_ends() { return nullptr; }

}  // namespace piae::libtorch
