#include "trend/options.hpp"

#include "base/range.hpp"

namespace piae::trend {

void bind(const cli::Options& command, TrendOptions& options) {
  constexpr Range rise_db{.low = 0.1, .high = 100, .unit = " dB"};
  constexpr Range spreads{.low = 0, .high = 100};
  constexpr Range alarm_db_h{.low = 1e-6, .high = 1e6, .unit = " dB h"};
  command
      .add("--least-rise-db", options.least_rise_db,
           "smallest rise above the healthy mean that counts, dB")
      .check(cli::within(rise_db));
  command
      .add("--spreads", options.spreads,
           "a rise counts beyond this multiple of the healthy standard deviation, too")
      .check(cli::within(spreads));
  command
      .add("--alarm-db-h", options.alarm_db_h,
           "rise beyond its limit times its duration that raises the alarm, dB h")
      .check(cli::within(alarm_db_h));
}

}  // namespace piae::trend
