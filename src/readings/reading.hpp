#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "run/grid.hpp"

namespace piae::readings {

/// One interpretation of the paper at points that it leaves open: settings of the paper's method
/// that differ from [readings] base in pipeline/protocol.toml.
struct Reading {
  std::string name;  ///< "batches=class+space=class"; "base" without differences

  /// Returns the folder of its cells below the folder of each seed:
  /// "readings/batches-class+space-class".
  [[nodiscard]] std::string folder() const;
};

struct ReadingsOptions {
  std::string dataset;
  std::vector<std::string>
      base;  ///< "batches=mixed": settings that an interpretation keeps unless it changes them
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

/// Throws Error(usage) as run::resolve() does, and for an interpretation that is not SETTING=VALUE,
/// or several of these joined by +.
Readings resolve(const ReadingsOptions& options);

}  // namespace piae::readings
