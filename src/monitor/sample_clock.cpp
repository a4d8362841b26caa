#include "monitor/sample_clock.hpp"

#include <algorithm>
#include <utility>

namespace piae::monitor {

double SampleClock::late_by(double now_s, std::uint64_t samples) {
  const double lag_s = now_s - static_cast<double>(samples) / rate_hz_;
  const double since_s = now_s - std::exchange(last_s_, now_s);
  if (!std::exchange(started_, true)) {
    least_lag_s_ = lag_s;
    return 0;
  }
  least_lag_s_ = std::min(lag_s, least_lag_s_ + drift * since_s);
  const double grown_s = lag_s - least_lag_s_;
  if (grown_s <= late_s_) return 0;
  least_lag_s_ = lag_s;
  ++times_;
  all_s_ += grown_s;
  return grown_s;
}

}  // namespace piae::monitor
