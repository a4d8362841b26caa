#pragma once

#include <cstdint>

#include "cli/options.hpp"

namespace piae::diagnosis {

/// Training settings of WDCNN. The literature gives none of these values; they were calibrated on
/// seeds 100 to 104 (pipeline/protocol.toml, [diagnose]).
struct WdcnnOptions {
  std::int64_t epochs = 50;     ///< passes over the training set
  std::int64_t batch = 32;      ///< windows per step
  double learning_rate = 5e-3;  ///< of Adam, constant
};

void bind(const cli::Options& command, WdcnnOptions& options);

}  // namespace piae::diagnosis
