#pragma once

#include <cstdint>

namespace piae::twin {

/// Sizes that all networks of a twin share.
struct NetworkShape {
  std::int64_t samples = 0;  ///< N, samples of a window
  std::int64_t classes =
      0;  ///< classes of the data set; a label is a one-hot vector of this length
};

}  // namespace piae::twin
