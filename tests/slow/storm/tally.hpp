#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>

namespace piae::storm {

/// Arguments of a part of the storm: PROGRAM CORPUS FOLDER COUNT SEED BIN.
struct Requested {
  std::filesystem::path corpus;
  std::filesystem::path folder;  ///< state and findings of this run
  std::size_t count = 0;
  std::size_t seed = 0;
  std::filesystem::path programs;
};

/// Reads the arguments. Throws std::runtime_error with the usage.
Requested requested_by(int argc, char** argv);

/// Counts the result of each input and stores the counts in the folder, so that an interrupted
/// storm continues.
class Tally {
 public:
  Tally(std::string part, const Requested& requested);

  [[nodiscard]] std::size_t done() const { return done_; }
  [[nodiscard]] bool finished() const { return done_ >= count_; }

  enum class Result { refused, accepted, missed };
  /// Counts one more input. Stores the counts every second and prints the time left every 20 s.
  void add(Result result);
  /// Stores the bytes of a missed input with a description.
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
  std::size_t done_before_ = 0;  ///< inputs of earlier runs
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point kept_ = started_;
  std::chrono::steady_clock::time_point told_ = started_;
};

}  // namespace piae::storm
