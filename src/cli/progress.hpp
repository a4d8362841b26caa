#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

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
  /// The same where not all parts take as long: `efforts` are what 0, 1, ... and all of them take
  /// together, in any unit. The part that is done and the time left are of these.
  Progress(std::string title, std::string unit, std::vector<double> efforts,
           std::size_t done_before = 0);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` counts from the beginning, those of `done_before` included; `note` ends the line.
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
  /// From when and what on the rate is counted: what went before was at another one, perhaps.
  Clock::time_point rate_from_;
  std::size_t rate_done_;
};

/// The seconds that the rest takes by what a part of the work has taken; `before`, `done` and `all`
/// in any unit, of which `done` - `before` took these seconds.
double seconds_left(double before, double done, double all, double seconds);

}  // namespace piae::cli
