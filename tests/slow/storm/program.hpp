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

/// True for a kept model by its name.
bool is_model(const std::filesystem::path& file);

/// True if a program that read this file took more than `most_mb`. Of a good model, `generate` and
/// `verify` make windows of up to 2^20 samples, of which a U-net keeps all features: 1.6 GB. So
/// they may take twice as much unless they refuse it.
bool took_too_much(const Outcome& outcome, const std::filesystem::path& file);

/// Runs a program on one thread in a folder; kills it and its children after `most_seconds`.
Outcome run(const std::filesystem::path& folder, const std::vector<std::string>& command);

}  // namespace piae::storm
