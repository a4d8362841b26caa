#include "nets/divergence.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>

#include "base/error.hpp"

namespace piae::nets {

void throw_diverged(const std::string& what, std::size_t epoch, const LearningRate& rate) {
  throw Error(Exit::failed, fmt::format("{} diverged in epoch {} with {} {:g}; use a smaller value",
                                        what, epoch, rate.option, rate.value));
}

void require_finite(double loss, const std::string& what, std::size_t epoch,
                    const LearningRate& rate) {
  if (!std::isfinite(loss)) throw_diverged(what, epoch, rate);
}

}  // namespace piae::nets
