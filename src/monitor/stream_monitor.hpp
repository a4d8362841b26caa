#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>

#include "monitor/sample_feed.hpp"

namespace piae::monitor {

/// Interface between watch() and a monitor: bytes in, lines of JSON out, counts for messages.
class StreamMonitor {
 public:
  using WriteLine = std::function<void(const std::string&)>;

  StreamMonitor() = default;
  StreamMonitor(const StreamMonitor&) = delete;
  StreamMonitor& operator=(const StreamMonitor&) = delete;
  virtual ~StreamMonitor() = default;

  /// Adds the next bytes and writes the decisions that they complete.
  virtual void take(std::span<const std::byte> bytes, const WriteLine& write) = 0;
  /// Marks a break: the next bytes do not continue the previous ones.
  virtual void skip() = 0;
  /// Judges the rest at the end of the stream.
  virtual void end(const WriteLine& write) = 0;

  [[nodiscard]] virtual const SampleFeed& feed() const = 0;
  [[nodiscard]] virtual std::size_t windows() const = 0;
  [[nodiscard]] virtual std::size_t alarms() const = 0;
  [[nodiscard]] virtual double window_s() const = 0;
};

}  // namespace piae::monitor
