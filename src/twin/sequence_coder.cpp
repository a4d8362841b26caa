#include "twin/sequence_coder.hpp"

#include <spdlog/fmt/fmt.h>

#include "base/error.hpp"

namespace piae::twin {

std::int64_t layers_except_dense(int depth, const std::string& layers) {
  if (depth < 2) {
    throw Error(Exit::usage, fmt::format("--depth: {} leaves no {}, because the layer at (k, c) is "
                                         "dense; use 2 or more",
                                         depth, layers));
  }
  return depth - 1;
}

std::int64_t frames_of(std::int64_t samples, std::int64_t frame, const std::string& handled) {
  if (samples % frame != 0) {
    throw Error(Exit::usage, fmt::format("windows of {} samples do not divide into frames of {} "
                                         "samples, which are {}; use multiples of {} samples "
                                         "(split --window)",
                                         samples, frame, handled, frame));
  }
  return samples / frame;
}

}  // namespace piae::twin
