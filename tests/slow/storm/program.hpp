#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace piae::storm {

/// Exit, output and resources of a program.
struct Outcome {
  int status = -1;    ///< exit status; 128 + signal after a signal
  bool hung = false;  ///< true if it was killed after the limit
  std::string out;
  std::string err;
  double seconds = 0;
  double peak_mb = 0;  ///< maximum of the program and each child
};

/// Limits of every program for any input.
inline constexpr double most_seconds = 20;
inline constexpr double most_mb = 1024;

/// Returns the limit of this program. `generate` accepts models of windows up to 2^20 samples, of
/// which a U-net keeps all features: 1.6 GB.
inline double most_mb_of(const std::string& program) {
  return program == "generate" ? 2 * most_mb : most_mb;
}

/// Runs a program on one thread in a folder; kills it and its children after `most_seconds`.
Outcome run(const std::filesystem::path& folder, const std::vector<std::string>& command);

}  // namespace piae::storm
