#pragma once

#include <cstddef>
#include <string>

namespace piae::nets {

/// The learning rate that a training was given, and by which option.
struct LearningRate {
  double value = 0;
  const char* option = "--learning-rate";
};

/// Throws Error(failed) for a training whose loss became NaN or infinite in an epoch, counted from
/// 1. `what` begins the line: "training".
[[noreturn]] void throw_diverged(const std::string& what, std::size_t epoch,
                                 const LearningRate& rate);

/// Throws so where the loss is not finite.
void require_finite(double loss, const std::string& what, std::size_t epoch,
                    const LearningRate& rate);

}  // namespace piae::nets
