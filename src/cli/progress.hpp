#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace piae::cli {

/// Shows on standard error how much is done, the rate and the time left. A terminal gets one line
/// that is rewritten; a log file gets a plain line every half minute.
class Progress {
 public:
  /// With the title "train" and the unit "epochs" the line is "train  ####....  34 %  12.1 epochs/s
  /// 0:11 left  loss 0.41". An earlier run did `done_before` of the total, which do not count for
  /// the rate.
  Progress(std::string title, std::string unit, std::size_t total, std::size_t done_before = 0);
  /// Takes parts of different effort: `efforts` are the cumulative efforts of 0, 1, ... and all
  /// parts, in any unit. Percentage and time left use them.
  Progress(std::string title, std::string unit, std::vector<double> efforts,
           std::size_t done_before = 0);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` includes `done_before`. `note` ends the line.
  void update(std::size_t done, const std::string& note = "");

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] std::string line(std::size_t done, const std::string& note, Clock::time_point now);

  std::string title_;
  std::string unit_;
  std::vector<double> efforts_;
  std::size_t done_before_;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point start_;
  Clock::time_point last_;
  /// Start of the period for the rate; earlier parts may have had another rate.
  Clock::time_point rate_from_;
  std::size_t rate_done_;
};

/// Returns the seconds that the rest will take if `done` - `before` took `seconds`. `before`,
/// `done` and `all` have the same unit.
double seconds_left(double before, double done, double all, double seconds);

}  // namespace piae::cli
