#pragma once

#include "cli/options.hpp"

namespace piae::trend {

/// When a rise above the healthy level is an alarm. The defaults were chosen on both axes of the
/// six learning bearings of PRONOSTIA, as round numbers without an alarm in the first 30 % of any
/// life (docs/monitoring.md). 5 dB, instead of 6, would give one; 0.3 to 0.6 dB h make no
/// difference there.
struct TrendOptions {
  /// Smallest rise that counts, in dB: twice the amplitude. Machines run in, warm up and change
  /// load, and an hour does not show how far they change in days. Condition monitoring commonly
  /// takes 6 to 8 dB for a significant change.
  double least_rise_db = 6;
  /// A rise counts only beyond this multiple of the standard deviation of the healthy windows, too.
  double spreads = 3;
  /// Rise beyond its limit times its duration that raises the alarm, in dB h: 6 dB for 5 minutes.
  double alarm_db_h = 0.5;
};

void bind(const cli::Options& command, TrendOptions& options);

}  // namespace piae::trend
