#include "signal/stream_resampler.hpp"

#include <soxr.h>
#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <cstddef>

#include "base/error.hpp"

namespace piae::signal {

struct StreamResampler::State {
  double from_hz;
  double to_hz;
  soxr_t soxr = nullptr;

  State(double from, double to) : from_hz(from), to_hz(to) {
    const soxr_io_spec_t io = soxr_io_spec(SOXR_FLOAT64_I, SOXR_FLOAT64_I);
    const soxr_quality_spec_t quality = soxr_quality_spec(SOXR_VHQ, 0);
    const soxr_runtime_spec_t one_thread = soxr_runtime_spec(1);
    soxr_error_t error = nullptr;
    soxr = soxr_create(from, to, 1, &error, &io, &quality, &one_thread);
    require(error);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() { soxr_delete(soxr); }

  void require(soxr_error_t error) const {
    if (error == nullptr) return;
    throw Error(Exit::failed,
                fmt::format("resampling from {:g} to {:g} Hz: {}", from_hz, to_hz, error));
  }

  /// Null samples end the signal.
  void process(const double* samples, std::size_t count, std::vector<double>& resampled) const {
    const double most = std::ceil(static_cast<double>(count) * to_hz / from_hz) + 1024;
    const auto room = static_cast<std::size_t>(most);
    for (std::size_t taken = 0, given = room; taken < count || given == room;) {
      const std::size_t before = resampled.size();
      resampled.resize(before + room);
      std::size_t used = 0;
      require(soxr_process(soxr, samples == nullptr ? nullptr : samples + taken, count - taken,
                           &used, resampled.data() + before, room, &given));
      resampled.resize(before + given);
      taken += used;
    }
  }
};

StreamResampler::StreamResampler(double from_hz, double to_hz) {
  if (from_hz != to_hz) state_ = std::make_unique<State>(from_hz, to_hz);
}

StreamResampler::~StreamResampler() = default;
StreamResampler::StreamResampler(StreamResampler&&) noexcept = default;
StreamResampler& StreamResampler::operator=(StreamResampler&&) noexcept = default;

void StreamResampler::add(std::span<const double> samples, std::vector<double>& resampled) {
  if (!state_) {
    resampled.insert(resampled.end(), samples.begin(), samples.end());
  } else if (!samples.empty()) {  // soxr would take nothing for the end
    state_->process(samples.data(), samples.size(), resampled);
  }
}

void StreamResampler::finish(std::vector<double>& resampled) {
  if (state_) state_->process(nullptr, 0, resampled);
}

}  // namespace piae::signal
