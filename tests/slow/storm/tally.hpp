#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>

namespace piae::storm {

/// How a storm's part is asked for: PROGRAM CORPUS FOLDER COUNT SEED [BIN].
struct Asked {
  std::filesystem::path corpus;
  std::filesystem::path folder;  ///< of this run alone: its state and what it found
  std::size_t count = 0;
  std::size_t seed = 0;
  std::filesystem::path programs;
};

/// Throws std::runtime_error with the usage.
Asked asked_by(int argc, char** argv);

/// Counts what came of each input, and keeps the count in the folder, so that a storm that was cut
/// goes on where it was.
class Tally {
 public:
  Tally(std::string part, const Asked& asked);

  [[nodiscard]] std::size_t done() const { return done_; }
  [[nodiscard]] bool finished() const { return done_ >= count_; }

  enum class Result { refused, accepted, missed };
  /// One more is done. Now and then the count is kept, and a line says how long the rest will take.
  void add(Result result);
  /// Keeps the bytes of an input that was not treated as promised, and what happened.
  void keep_finding(const std::string& name, const std::string& bytes, const std::string& what);
  /// Prints the last line, "PART: 10000 done, 9000 refused, 1000 accepted, 0 missed"; returns the
  /// exit code.
  int finish();

 private:
  void keep();

  std::string part_;
  std::filesystem::path folder_;
  std::size_t count_;
  std::size_t done_ = 0;
  std::size_t refused_ = 0;
  std::size_t accepted_ = 0;
  std::size_t missed_ = 0;
  std::size_t done_before_ = 0;  ///< by an earlier run
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point kept_ = started_;
  std::chrono::steady_clock::time_point told_ = started_;
};

}  // namespace piae::storm
