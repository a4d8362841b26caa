#include "machines/healthy.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <string>

#include "bearing/kinematics.hpp"
#include "impacts/path.hpp"
#include "impacts/response.hpp"
#include "impacts/synthesis.hpp"
#include "zero/background.hpp"
#include "zero/draws.hpp"

namespace piae::machines {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;

constexpr double turn = 2 * std::numbers::pi;
constexpr double largest_slip = 0.008;
constexpr double stray_strength = 20;  // standard deviation / that of the noise
constexpr double level_scatter = 0.1;  // of the logarithm

ArrayXd draw_path(Index bins, double spread_db, Stream& random) {
  return impacts::draw_gains(random, bins, {.spread_db = spread_db, .knots = zero::path_knots});
}

/// Returns 1 plus the machine's modulation, for each sample of a frame.
ArrayXd modulation_of(const Machine& machine, Index samples, Stream& random) {
  const double slip = zero::evenly(random, -largest_slip, largest_slip);
  const bearing::FaultFrequencies lines =
      bearing::fault_frequencies(machine.info.bearing, machine.info.shaft_speed_rpm, slip);
  const double rates_hz[] = {lines.bpfo_hz, lines.bpfi_hz, 2 * lines.bsf_hz, lines.shaft_hz};
  const ArrayXd time_s = ArrayXd::LinSpaced(samples, 0, static_cast<double>(samples - 1)) /
                         machine.info.sample_rate_hz;
  ArrayXd factor = ArrayXd::Ones(samples);
  for (std::size_t i = 0; i < machine.modulation.size(); ++i) {
    const double phase = zero::evenly(random, 0, turn);
    factor += machine.modulation.at(i) * (turn * rates_hz[i] * time_s + phase).cos();
  }
  return factor;
}

ArrayXd draw_noise(const Machine& machine, const ArrayXd& amplitude, Stream& random) {
  const auto frame = static_cast<Index>(2 * machine.length);
  ArrayXd noise(frame);
  for (double& sample : noise) sample = random.normal(0, 1);
  noise *= modulation_of(machine, frame, random);
  const std::size_t strays = zero::poisson(random, machine.stray_impacts);
  for (std::size_t i = 0; i < strays; ++i) {
    noise[static_cast<Index>(random.below(static_cast<std::size_t>(frame)))] +=
        stray_strength * random.normal(0, 1);
  }
  const Eigen::ArrayXcd gains = amplitude.cast<std::complex<double>>();
  impacts::filter({noise.data(), static_cast<std::size_t>(noise.size())},
                  {gains.data(), static_cast<std::size_t>(gains.size())});
  return impacts::window_of(noise, machine.length);
}

/// Returns all tones of a window, with the machine's power.
ArrayXd draw_tone_window(const Machine& machine, Stream& random) {
  const auto samples = static_cast<Index>(machine.length);
  const ArrayXd time_s = ArrayXd::LinSpaced(samples, 0, static_cast<double>(samples - 1)) /
                         machine.info.sample_rate_hz;
  ArrayXd sum = ArrayXd::Zero(samples);
  for (const Machine::Tone& tone : machine.tones) {
    const double phase = zero::evenly(random, 0, turn);
    const ArrayXd sine = tone.amplitude * (turn * tone.hz * time_s + phase).sin();
    if (tone.of_shaft) {
      sum += sine;
    } else {
      const double depth = zero::evenly(random, 0, 0.5);
      const double shaft_hz = machine.info.shaft_speed_rpm / 60;
      sum += sine * (1 + depth * (turn * shaft_hz * time_s + 2 * phase).cos());
    }
  }
  const double power = sum.square().mean();
  return power > 0 ? ArrayXd(sum * std::sqrt(machine.tone_power / power)) : sum;
}

}  // namespace

signal::WindowSet healthy_windows(const Machine& machine, std::size_t count, Day day,
                                  const Stream& stream) {
  const auto bins = static_cast<Index>(machine.length + 1);
  Stream of_day = stream.child("day");
  ArrayXd amplitude = machine.log_amplitude.exp();
  if (day == Day::other) amplitude *= draw_path(bins, machine.day_db, of_day);
  signal::WindowSet set;
  set.info = machine.info;
  set.length = machine.length;
  for (std::size_t i = 0; i < count; ++i) {
    Stream random = stream.child(std::to_string(i));
    ArrayXd window =
        draw_noise(machine, amplitude * draw_path(bins, machine.window_db, random), random) +
        draw_tone_window(machine, random);
    for (double& sample : window) sample += machine.sensor_noise * random.normal(0, 1);
    window *= std::exp(random.normal(0, level_scatter));
    for (const double sample : window) set.samples.push_back(static_cast<float>(sample));
    set.labels.push_back(machine.info.healthy_label());
  }
  return set;
}

}  // namespace piae::machines
