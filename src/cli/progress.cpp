#include "cli/progress.hpp"

#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace piae::cli {

namespace {

constexpr std::size_t bar_width = 24;

std::string bar(std::size_t done, std::size_t total) {
  const std::size_t filled = total == 0 ? bar_width : std::min(bar_width, done * bar_width / total);
  return std::string(filled, '#') + std::string(bar_width - filled, '.');
}

std::string minutes(double seconds) {
  const long s = std::lround(seconds);
  return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                  : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

}  // namespace

Progress::Progress(std::string title, std::string unit, std::size_t total, std::size_t done_before)
    : title_(std::move(title)),
      unit_(std::move(unit)),
      total_(total),
      done_before_(done_before),
      terminal_(isatty(STDERR_FILENO) != 0),
      start_(Clock::now()),
      last_(start_) {}

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

std::string Progress::line(std::size_t done, const std::string& note, Clock::time_point now) const {
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double rate = static_cast<double>(done - done_before_) / std::max(seconds, 1e-9);
  const double left = rate > 0 ? static_cast<double>(total_ - done) / rate : 0.0;
  return fmt::format("{}  {}  {:3} %  {:.3g} {}/s  {} left  {}", title_, bar(done, total_),
                     total_ == 0 ? 100 : done * 100 / total_, rate, unit_, minutes(left), note);
}

}  // namespace piae::cli
