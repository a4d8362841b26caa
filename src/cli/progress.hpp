#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace piae::cli {

/// One line with share done, rate and time left: rewritten in place on a terminal, and elsewhere
/// (a log file, a cluster) a plain line every half minute. Writes to standard error.
class Progress {
 public:
  /// "train  ####....  34 %  12.1 epochs/s  0:11 left  loss 0.41"
  Progress(std::string title, std::string unit, std::size_t total, std::size_t done_before = 0);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(std::size_t done, const std::string& note = "");

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] std::string line(std::size_t done, const std::string& note,
                                 Clock::time_point now) const;

  std::string title_;
  std::string unit_;
  std::size_t total_;
  std::size_t done_before_;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point start_;
  Clock::time_point last_;
};

}  // namespace piae::cli
