#pragma once

#include <cstdint>

namespace piae::twin {

/// The sizes that all networks of a twin share.
struct NetworkShape {
  std::int64_t samples = 0;  ///< N, in a window
  std::int64_t classes = 0;  ///< in the dataset; a label is given as a one-hot vector of these
};

}  // namespace piae::twin
