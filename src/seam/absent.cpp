// Linked into programs without LibTorch.

#include "seam/libtorch.hpp"

namespace piae::seam {

const BackEnds* back_ends() { return nullptr; }

}  // namespace piae::seam
