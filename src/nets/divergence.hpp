#pragma once

#include <cstddef>
#include <string>

namespace piae::nets {

/// The learning rate of a training, and the option that sets it.
struct LearningRate {
  double value = 0;
  const char* option = "--learning-rate";
};

/// Throws Error(failed) for a training whose loss became NaN or infinite in an epoch, counted from
/// 1. `what` is the start of the message: "training".
[[noreturn]] void throw_diverged(const std::string& what, std::size_t epoch,
                                 const LearningRate& rate);

/// Calls throw_diverged() if the loss is not finite.
void require_finite(double loss, const std::string& what, std::size_t epoch,
                    const LearningRate& rate);

}  // namespace piae::nets
