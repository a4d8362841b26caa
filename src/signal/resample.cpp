#include "signal/resample.hpp"

#include <soxr.h>
#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <cstddef>

#include "base/error.hpp"

namespace piae::signal {

namespace {

struct SoxrSettings {
  soxr_io_spec_t io = soxr_io_spec(SOXR_FLOAT64_I, SOXR_FLOAT64_I);
  soxr_quality_spec_t quality = soxr_quality_spec(SOXR_VHQ, 0);
  soxr_runtime_spec_t one_thread = soxr_runtime_spec(1);
};

void require_resampled(soxr_error_t error, double from_hz, double to_hz) {
  if (error == nullptr) return;
  throw Error(Exit::failed,
              fmt::format("resampling from {:g} to {:g} Hz: {}", from_hz, to_hz, error));
}

}  // namespace

std::vector<double> resample(std::span<const double> signal, double from_hz, double to_hz) {
  if (from_hz == to_hz) return {signal.begin(), signal.end()};
  const double length = std::floor(static_cast<double>(signal.size()) * to_hz / from_hz);
  std::vector<double> out(static_cast<std::size_t>(length));
  if (out.empty()) return out;  // soxr cannot return zero samples
  const SoxrSettings settings;
  std::size_t done = 0;
  require_resampled(
      soxr_oneshot(from_hz, to_hz, 1, signal.data(), signal.size(), nullptr, out.data(), out.size(),
                   &done, &settings.io, &settings.quality, &settings.one_thread),
      from_hz, to_hz);
  if (done != out.size()) require_resampled("soxr gave too few samples", from_hz, to_hz);
  return out;
}

struct StreamResampler::State {
  double from_hz;
  double to_hz;
  soxr_t soxr = nullptr;

  State(double from, double to) : from_hz(from), to_hz(to) {
    const SoxrSettings settings;
    soxr_error_t error = nullptr;
    soxr = soxr_create(from, to, 1, &error, &settings.io, &settings.quality, &settings.one_thread);
    require_resampled(error, from, to);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() { soxr_delete(soxr); }

  /// Appends resampled samples. Null samples end the signal.
  void process(const double* samples, std::size_t count, std::vector<double>& resampled) const {
    const double most = std::ceil(static_cast<double>(count) * to_hz / from_hz) + 1024;
    const auto room = static_cast<std::size_t>(most);
    for (std::size_t taken = 0, given = room; taken < count || given == room;) {
      const std::size_t before = resampled.size();
      resampled.resize(before + room);
      std::size_t used = 0;
      require_resampled(soxr_process(soxr, samples == nullptr ? nullptr : samples + taken,
                                     count - taken, &used, resampled.data() + before, room, &given),
                        from_hz, to_hz);
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
  } else if (!samples.empty()) {  // soxr takes an empty input for the end
    state_->process(samples.data(), samples.size(), resampled);
  }
}

void StreamResampler::finish(std::vector<double>& resampled) {
  if (state_) state_->process(nullptr, 0, resampled);
}

}  // namespace piae::signal
