#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace piae::cli {

/// Shows on standard error how much is done, how fast it goes and how long it will take: on a
/// terminal in one line that is rewritten, elsewhere (a log file, a cluster) in a plain line every
/// half minute.
class Progress {
 public:
  /// With the title "train" and the unit "epochs" the line is
  /// "train  ####....  34 %  12.1 epochs/s  0:11 left  loss 0.41". `done_before` of the total were
  /// done by an earlier run and say nothing about the rate.
  Progress(std::string title, std::string unit, std::size_t total, std::size_t done_before = 0);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` counts from the beginning, those of `done_before` included; `note` ends the line.
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
