#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace piae::storm {

/// How a program ended, what it said, and what it took.
struct Outcome {
  int status = -1;    ///< exit status; 128 + signal where a signal ended it
  bool hung = false;  ///< it was killed after the limit
  std::string out;
  std::string err;
  double seconds = 0;
  double peak_mb = 0;  ///< of the program, or of one of its children where that took more
};

/// What every program keeps to, whatever it is given.
inline constexpr double most_seconds = 20;
inline constexpr double most_mb = 1024;

/// Runs a program on one thread in a folder; it and its children are killed after `most_seconds`.
Outcome run(const std::filesystem::path& folder, const std::vector<std::string>& command);

}  // namespace piae::storm
