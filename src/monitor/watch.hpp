#pragma once

#include <functional>
#include <string>

#include "monitor/input.hpp"
#include "monitor/stream_monitor.hpp"

namespace piae::monitor {

struct WatchOptions {
  bool realtime = false;  ///< compare the samples with the clock
  double late_s = 1;      ///< delay in s above which late samples are reported
};

void bind(const cli::Options& command, WatchOptions& options);

/// Reads a stream until it ends or `stopped` returns true, and passes the decisions to `write` as
/// lines. Reports gaps and delays on standard error at once. Returns a summary line: windows,
/// alarms and lost samples. Throws Error(bad_input) if the stream ends before a window is full.
std::string watch(Input& input, StreamMonitor& monitor, const WatchOptions& options,
                  const std::function<bool()>& stopped,
                  const std::function<void(const std::string&)>& write);

}  // namespace piae::monitor
