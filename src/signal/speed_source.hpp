#pragma once

#include <optional>
#include <string>

#include "signal/toml_table.hpp"

namespace piae::signal {

/// Source of the speed of a record over its time.
struct SpeedSource {
  /// File below DATA_DIR with a time for each pulse of a tachometer; empty: a channel of the
  /// record's own files holds the speed.
  std::string file = {};
  std::string variable = {};  ///< times in s from the start of the record; or speeds in rpm
  double pulses_per_turn = 1;
};

/// Reads shaft_speed_rpm of a record, if it is not a number:
///
///     shaft_speed_rpm = "speed"   # variable of the record's own files: speeds in rpm, which cover
///                                 # the record evenly, at any rate
///     shaft_speed_rpm = { file = "rig/tacho.csv", variable = "1", pulses_per_turn = 60 }
///
/// Throws Error(bad_input) as TomlTable does, and for a file outside the data folder.
std::optional<SpeedSource> read_speed_source(TomlTable& record);

}  // namespace piae::signal
