#include "augment/healthy_model.hpp"

#include <spdlog/fmt/fmt.h>

#include "base/error.hpp"

namespace piae::augment {

const signal::WindowSet& require_healthy(const std::optional<signal::WindowSet>& healthy,
                                         const signal::WindowSet& known) {
  if (!healthy) {
    throw Error(Exit::usage,
                "--healthy is missing: this method needs healthy windows; give "
                "--healthy B.h5 of the same split");
  }
  if (healthy->length != known.length) {
    throw Error(
        Exit::bad_input,
        fmt::format("healthy windows have {} samples, but known windows have {}; give B and "
                    "C of one split",
                    healthy->length, known.length));
  }
  return *healthy;
}

}  // namespace piae::augment
