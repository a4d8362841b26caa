#pragma once

#include <cstdint>

namespace piae::twin {

/// Sizes that the networks share.
struct NetworkShape {
  std::int64_t samples = 0;  ///< of a window, N
  std::int64_t classes = 0;  ///< of the dataset; the label enters as a one-hot vector
};

}  // namespace piae::twin
