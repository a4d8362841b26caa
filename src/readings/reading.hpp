#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "run/grid.hpp"

namespace piae::readings {

/// One way to read the paper where its words leave a choice: settings of the paper's method that
/// differ from those of [readings] base in pipeline/protocol.toml.
struct Reading {
  std::string name;  ///< "batches=class+space=class"; "base" where nothing differs

  /// The folder of its cells below that of each seed: "readings/batches-class+space-class".
  [[nodiscard]] std::string folder() const;
};

struct ReadingsOptions {
  std::string dataset;
  std::vector<std::string> base;  ///< "batches=mixed": what a reading has unless it says otherwise
  std::vector<std::string> readings;
  std::vector<std::string> ratios;
  std::vector<std::string> seeds;
};

void bind(const cli::Options& command, ReadingsOptions& options);

struct Readings {
  run::Grid grid;  ///< of the paper's method: ratios and seeds
  std::vector<std::string> base;
  std::vector<Reading> readings;  ///< base is the first
};

/// Throws Error(usage) as run::resolve() does, and for a reading that is not SETTING=VALUE, or
/// several of these joined by +.
Readings resolve(const ReadingsOptions& options);

}  // namespace piae::readings
