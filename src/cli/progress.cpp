#include "cli/progress.hpp"

#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <utility>

namespace piae::cli {

namespace {

constexpr std::size_t bar_width = 24;

constexpr double rate_interval_s = 5;

std::string bar(double part) {
  const auto filled = static_cast<std::size_t>(part * static_cast<double>(bar_width));
  return std::string(filled, '#') + std::string(bar_width - filled, '.');
}

/// Returns efforts of equal parts: 0, 1, ..., total.
std::vector<double> alike(std::size_t total) {
  std::vector<double> efforts(total + 1);
  std::iota(efforts.begin(), efforts.end(), 0.0);
  return efforts;
}

std::string minutes(double seconds) {
  const long s = std::lround(seconds);
  return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                  : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

}  // namespace

Progress::Progress(std::string title, std::string unit, std::size_t total, std::size_t done_before)
    : Progress(std::move(title), std::move(unit), alike(total), done_before) {}

Progress::Progress(std::string title, std::string unit, std::vector<double> efforts,
                   std::size_t done_before)
    : title_(std::move(title)),
      unit_(std::move(unit)),
      efforts_(std::move(efforts)),
      done_before_(done_before),
      terminal_(isatty(STDERR_FILENO) != 0),
      start_(Clock::now()),
      last_(start_),
      rate_from_(start_),
      rate_done_(done_before) {}

Progress::~Progress() {
  if (terminal_ && shown_) std::fputs("\r\033[K", stderr);
}

void Progress::update(std::size_t done, const std::string& note) {
  const Clock::time_point now = Clock::now();
  const auto interval = terminal_ ? std::chrono::milliseconds(100) : std::chrono::seconds(30);
  if (now - last_ < interval) return;
  last_ = now;
  shown_ = true;
  const std::string text = line(done, note, now);
  std::fputs((terminal_ ? "\r\033[K" + text : text + "\n").c_str(), stderr);
  std::fflush(stderr);
}

std::string Progress::line(std::size_t done, const std::string& note, Clock::time_point now) {
  const auto seconds_since = [&](Clock::time_point then) {
    return std::max(std::chrono::duration<double>(now - then).count(), 1e-9);
  };
  const double rate = static_cast<double>(done - rate_done_) / seconds_since(rate_from_);
  if (seconds_since(rate_from_) > rate_interval_s) {
    rate_from_ = now;
    rate_done_ = done;
  }
  const double all = efforts_.back();
  const double effort = efforts_.at(std::min(done, efforts_.size() - 1));
  const double part = all > 0 ? effort / all : 1;
  const double left = seconds_left(efforts_.at(done_before_), effort, all, seconds_since(start_));
  return fmt::format("{}  {}  {:3} %  {:.3g} {}/s  {} left  {}", title_, bar(part),
                     static_cast<int>(100 * part), rate, unit_, minutes(left), note);
}

double seconds_left(double before, double done, double all, double seconds) {
  return done > before ? (all - done) * seconds / (done - before) : 0;
}

}  // namespace piae::cli
