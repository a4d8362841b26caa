#pragma once

#include <functional>
#include <string>

#include "monitor/input.hpp"
#include "monitor/monitor.hpp"

namespace piae::monitor {

struct WatchOptions {
  bool realtime = false;  ///< compare the samples with the clock
  double late_s = 1;      ///< by how much they may lag behind it before that is told
};

void bind(const cli::Options& command, WatchOptions& options);

/// Reads a stream until it ends, or `stopped` says so, and gives `write` the decisions as lines.
/// Gaps and delays are told on standard error as they come. Returns the last line: what was heard,
/// how many alarms there were, and what was lost. Throws Error(bad_input) where the stream ends
/// before a window is full.
std::string watch(Input& input, Monitor& monitor, const signal::DatasetInfo& info,
                  const WatchOptions& options, const std::function<bool()>& stopped,
                  const std::function<void(const std::string&)>& write);

}  // namespace piae::monitor
