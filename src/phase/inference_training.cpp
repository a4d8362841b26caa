#include "phase/inference_training.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/columns.hpp"
#include "base/error.hpp"
#include "nets/divergence.hpp"
#include "spectra/floors.hpp"
#include "twin/physics.hpp"

namespace piae::phase {

namespace {

using twin::damping_scale_ns_per_m;
using twin::stiffness_scale_n_per_m;

constexpr std::size_t rounds = 2;
/// The first round has this factor fewer windows than the last, because it only has to find the
/// neighbourhood of the known (k, c).
constexpr int fewer_in_first_round = 3;
/// Number of noise realisations that the epochs use in turn. More do not improve the result.
constexpr std::size_t noise_realisations = 4;
/// The second round draws (k, c) between the class's median divided by these factors and the median
/// times them.
constexpr double prior_factor_k = 1.5;
constexpr double prior_factor_c = 2;
/// Cost of simulating a lesson, with features for all noise realisations, relative to learning from
/// it once. Used only to estimate the remaining time.
constexpr double effort_of_a_simulation = 40;
/// The longest sub-step of the solution of eq. 13. It is coarse: its error is 1 % of the waveform,
/// which is below the added noise.
constexpr double sub_step_s = 6e-6;

std::vector<twin::TwinPoint> points_of(const signal::WindowSet& windows) {
  std::vector<twin::TwinPoint> points;
  for (const signal::DynamicParameters& p : windows.parameters) {
    points.push_back(twin::without_units(p));
  }
  return points;
}

double draw_log(Stream& stream, double low, double high) {
  return std::exp(stream.uniform(std::log(low), std::log(high)));
}

/// Narrows the bounds to centre / factor and centre * factor, where these lie between the bounds. A
/// centre outside the bounds is first moved to the nearer bound.
void narrow(double& low, double& high, double centre, double factor) {
  centre = std::clamp(centre, low, high);
  low = std::max(low, centre / factor);
  high = std::min(high, centre * factor);
}

signal::WindowSet with_noise(signal::WindowSet windows, const Stream& stream, double snr_to_db) {
  for (std::size_t i = 0; i < windows.size(); ++i) {
    Stream noise = stream.child(std::to_string(i));
    const std::span<float> window =
        std::span(windows.samples).subspan(i * windows.length, windows.length);
    double power = 0;
    for (const float x : window) power += static_cast<double>(x) * x;
    const double snr_db = noise.uniform(0, snr_to_db);
    const double deviation =
        std::sqrt(power / static_cast<double>(windows.length) * std::pow(10, -snr_db / 10));
    for (float& x : window) x += static_cast<float>(noise.normal(0, deviation));
  }
  return windows;
}

}  // namespace

InferenceTraining::InferenceTraining(const signal::WindowSet& known,
                                     const signal::SimulationOptions& simulation,
                                     const InferenceOptions& options, const Stream& stream)
    : known_(known),
      simulation_(signal::simulation_like(known, simulation)),
      options_(options),
      stream_(stream),
      inference_(static_cast<std::int64_t>(known.info.classes.size()), options.width, options.batch,
                 stream.child("initial")) {
  simulation_.options.dynamics.max_sub_step_s = sub_step_s;
  const Bounds bounds = first_bounds();
  if (bounds.low.k >= bounds.high.k || bounds.low.c >= bounds.high.c) {
    throw Error(Exit::usage,
                "inference: the range to search is empty; "
                "give --stiffness-from-n-per-m below load / clearance and "
                "--damping-from-ns-per-m below --damping-to-ns-per-m");
  }
}

std::size_t InferenceTraining::epochs() const {
  return rounds * static_cast<std::size_t>(options_.epochs);
}

std::size_t InferenceTraining::lessons_of_a_class(std::size_t round) const {
  const bool is_last = round + 1 == rounds;
  const int count =
      is_last ? options_.simulations : std::max(1, options_.simulations / fewer_in_first_round);
  return static_cast<std::size_t>(count);
}

double InferenceTraining::effort(std::size_t epoch) const {
  const auto epochs_of_round = static_cast<std::size_t>(options_.epochs);
  const auto lessons = static_cast<double>(lessons_of_a_class(epoch / epochs_of_round) *
                                           known_.info.fault_labels().size());
  return epoch % epochs_of_round == 0 ? (1 + effort_of_a_simulation) * lessons : lessons;
}

Bounds InferenceTraining::first_bounds() const {
  const double largest_n_per_m = bearing::largest_stiffness_n_per_m(simulation_.options.dynamics);
  return {
      .low = twin::without_units({.stiffness_n_per_m = options_.stiffness_from_n_per_m,
                                  .damping_ns_per_m = options_.damping_from_ns_per_m}),
      .high = twin::without_units(
          {.stiffness_n_per_m = largest_n_per_m, .damping_ns_per_m = options_.damping_to_ns_per_m}),
  };
}

std::vector<Bounds> InferenceTraining::bounds_around_known() {
  const std::vector<twin::TwinPoint> points = inference_.infer(known_);
  std::vector<Bounds> bounds(known_.info.classes.size(), first_bounds());
  for (Label label = 0; index_of(label) < bounds.size(); ++label) {
    std::vector<double> k;
    std::vector<double> c;
    for (const std::size_t i : known_.indices_of(label)) {
      k.push_back(points[i].k);
      c.push_back(points[i].c);
    }
    if (k.empty()) continue;
    Bounds& own = bounds[index_of(label)];
    narrow(own.low.k, own.high.k, spectra::median(k), prior_factor_k);
    narrow(own.low.c, own.high.c, spectra::median(c), prior_factor_c);
  }
  return bounds;
}

void InferenceTraining::prepare_lessons(std::size_t round, const std::vector<Bounds>& bounds) {
  const Stream stream = stream_.child("round" + std::to_string(round));
  const signal::WindowSet windows = signal::simulate_windows(
      simulation_, lessons_of_a_class(round), stream, [&](Label label, Stream& own) {
        const auto& [low, high] = bounds[index_of(label)];
        bearing::DynamicsOptions dynamics = simulation_.options.dynamics;
        dynamics.stiffness_n_per_m = draw_log(own, low.k, high.k) * stiffness_scale_n_per_m;
        dynamics.damping_ns_per_m = draw_log(own, low.c, high.c) * damping_scale_ns_per_m;
        return dynamics;
      });
  lessons_ = {.features = {}, .labels = windows.labels, .points = points_of(windows)};
  for (std::size_t i = 0; i < noise_realisations; ++i) {
    const Stream noise = stream.child("noise" + std::to_string(i));
    lessons_.features.push_back(
        inference_.features_of(with_noise(windows, noise, options_.snr_to_db)));
  }
}

std::string InferenceTraining::run_epoch(std::size_t epoch) {
  const auto epochs_of_round = static_cast<std::size_t>(options_.epochs);
  const std::size_t round = epoch / epochs_of_round;
  const std::size_t of_round = epoch % epochs_of_round;
  if (of_round == 0) {
    const std::vector<Bounds> bounds = round == 0
                                           ? std::vector(known_.info.classes.size(), first_bounds())
                                           : bounds_around_known();
    prepare_lessons(round, bounds);
    inference_.set_scale(bounds, lessons_.features.front());
  } else if (lessons_.features.empty()) {  // continued from a checkpoint within the round
    prepare_lessons(round, inference_.bounds());
  }
  const double progress = static_cast<double>(of_round) / static_cast<double>(epochs_of_round);
  const double learning_rate =
      options_.learning_rate * (1 + std::cos(std::numbers::pi * progress)) / 2;
  Stream shuffle = stream_.child("epoch" + std::to_string(epoch));
  const double loss = learn(lessons_.features[epoch % noise_realisations], shuffle, learning_rate);
  nets::require_finite(loss, "the inference of (k, c)", epoch + 1,
                       {.value = options_.learning_rate, .option = "--inference-learning-rate"});
  return fmt::format("inference, round {}, loss {:.3f}", round + 1, loss);
}

double InferenceTraining::learn(const nets::RowArray<float>& features, Stream& shuffle,
                                double learning_rate) {
  const nets::RowArray<float> targets = inference_.targets_of(lessons_.points, lessons_.labels);
  const std::vector<std::size_t> order = shuffle.permutation(lessons_.points.size());
  const auto batch = static_cast<std::size_t>(options_.batch);
  double sum = 0;
  for (std::size_t begin = 0; begin < order.size(); begin += batch) {
    const auto rows = std::span(order).subspan(begin, std::min(batch, order.size() - begin));
    std::vector<Label> labels;
    for (const std::size_t row : rows) labels.push_back(lessons_.labels[row]);
    const double loss = inference_.learn(features(rows, every_column(features)), labels,
                                         targets(rows, every_column(targets)), learning_rate);
    sum += loss * static_cast<double>(rows.size());
  }
  return sum / static_cast<double>(order.size());
}

void InferenceTraining::write_state(artefact::Writer& writer) const {
  inference_.write(writer);
  inference_.write_adam(writer);
}

void InferenceTraining::read_state(const artefact::Reader& reader) {
  inference_.read(reader);
  inference_.read_adam(reader);
}

}  // namespace piae::phase
