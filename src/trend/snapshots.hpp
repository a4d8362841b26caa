#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "signal/recordings.hpp"
#include "trend/timed_window.hpp"

namespace piae::trend {

/// Returns the record of this name. An empty name stands for the only record. Throws
/// Error(bad_input) if the record does not exist, or if several could be meant.
const signal::Record& record_called(const signal::Recordings& recordings, const std::string& name);

/// Returns the length of the windows that a record is watched in, in samples. Snapshots give one
/// window each: `window_s`, or the length of the shortest snapshot if that is 0. A continuous
/// record is cut into windows of `window_s`, or 1 s. Throws Error(bad_input) if no snapshot, or the
/// whole record, is as long as a window.
std::size_t window_of(const signal::Record& record, double rate_hz, double window_s);

/// Passes the windows of a record on in order of time, with their speeds if these were recorded.
/// Snapshots that are shorter than a window are left out.
void for_each_window(const signal::Record& record, double rate_hz, std::size_t length,
                     const std::function<void(const TimedWindow&)>& take);

}  // namespace piae::trend
