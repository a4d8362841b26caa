#include "signal/resample.hpp"

#include <soxr.h>

#include <cmath>
#include <string>

#include "base/error.hpp"

namespace piae::signal {

std::vector<double> resample(std::span<const double> signal, double from_hz, double to_hz) {
  if (from_hz == to_hz) return {signal.begin(), signal.end()};
  const double length = std::floor(static_cast<double>(signal.size()) * to_hz / from_hz);
  std::vector<double> out(static_cast<std::size_t>(length));
  if (out.empty()) return out;  // soxr cannot be asked for nothing
  const soxr_io_spec_t io = soxr_io_spec(SOXR_FLOAT64_I, SOXR_FLOAT64_I);
  const soxr_quality_spec_t quality = soxr_quality_spec(SOXR_VHQ, 0);
  const soxr_runtime_spec_t one_thread = soxr_runtime_spec(1);
  std::size_t done = 0;
  const soxr_error_t error =
      soxr_oneshot(from_hz, to_hz, 1, signal.data(), signal.size(), nullptr, out.data(), out.size(),
                   &done, &io, &quality, &one_thread);
  if (error != nullptr || done != out.size()) {
    throw Error(Exit::failed,
                "resampling from " + std::to_string(from_hz) + " to " + std::to_string(to_hz) +
                    " Hz: " + (error != nullptr ? error : "soxr gave too few samples"));
  }
  return out;
}

}  // namespace piae::signal
