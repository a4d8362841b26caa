#include "diffusion/training.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "nets/divergence.hpp"
#include "nets/stored_parameters.hpp"
#include "phase/class_cycle.hpp"
#include "signal/scaling.hpp"

namespace piae::diffusion {

namespace {

std::vector<float> cycle_of_window(const signal::DatasetInfo& info, std::span<const float> window,
                                   Label label) {
  const signal::Cycle cycle = phase::cycle_of_class(info, label, window.size());
  const std::vector<double> closed =
      signal::closed_cycle(std::vector<double>(window.begin(), window.end()), cycle);
  return {closed.begin(), closed.end()};
}

std::int64_t most_windows_of(const std::vector<Lesson>& lessons) {
  std::int64_t most = 0;
  for (const Lesson& lesson : lessons) {
    most = std::max(most, std::min<std::int64_t>(lesson.course.batch, std::ssize(lesson.labels)));
  }
  return most;
}

bool are_finite(const std::vector<float>& values) {
  return std::ranges::all_of(values, [](float value) { return std::isfinite(value); });
}

/// Returns the learning rate of an epoch: half a cosine from the first to zero.
double rate_at(const Course& course, std::size_t epoch) {
  const double done = (static_cast<double>(epoch) + 0.5) / course.epochs;
  return course.learning_rate * (1 + std::cos(std::numbers::pi * done)) / 2;
}

}  // namespace

Lesson lesson_of(const signal::WindowSet& windows, const std::vector<double>& rms, Angle angle,
                 const Course& course) {
  Lesson lesson{.windows = signal::scaled_windows(windows, rms),
                .labels = windows.labels,
                .cycles = {},
                .course = course};
  if (angle == Angle::known) return lesson;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const auto window = std::span(lesson.windows).subspan(i * windows.length, windows.length);
    lesson.cycles.push_back(cycle_of_window(windows.info, window, windows.labels[i]));
  }
  return lesson;
}

DiffusionTraining::DiffusionTraining(DiffusionModel model, std::vector<Lesson> lessons,
                                     double dropped, const Stream& stream,
                                     const MakeBackend& make_backend)
    : model_(std::move(model)),
      lessons_(std::move(lessons)),
      dropped_(dropped),
      stream_(stream),
      backend_(make_backend(model_.networks, most_windows_of(lessons_), stream.child("initial"))) {}

std::size_t DiffusionTraining::epochs() const {
  std::size_t epochs = 0;
  for (const Lesson& lesson : lessons_) epochs += static_cast<std::size_t>(lesson.course.epochs);
  return epochs;
}

DiffusionTraining::Place DiffusionTraining::place_of(std::size_t epoch) const {
  std::size_t network = 0;
  while (epoch >= static_cast<std::size_t>(lessons_[network].course.epochs)) {
    epoch -= static_cast<std::size_t>(lessons_[network++].course.epochs);
  }
  return {.network = network, .epoch = epoch};
}

double DiffusionTraining::effort(std::size_t epoch) const {
  return static_cast<double>(lessons_[place_of(epoch).network].labels.size());
}

std::vector<float> DiffusionTraining::window_of(const Lesson& lesson, std::size_t i,
                                                Stream& random) const {
  const auto length = static_cast<std::size_t>(model_.samples());
  if (!lesson.cycles.empty()) {
    const std::vector<float>& cycle = lesson.cycles[i];
    return signal::read(std::span(cycle), random.below(cycle.size()), length);
  }
  const auto first = lesson.windows.begin() + static_cast<std::ptrdiff_t>(i * length);
  return {first, first + static_cast<std::ptrdiff_t>(length)};
}

DiffusionTraining::Drawn DiffusionTraining::draw(const Lesson& lesson,
                                                 std::span<const std::size_t> windows,
                                                 Stream& random) const {
  Drawn drawn;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const double u =
        (static_cast<double>(i) + random.uniform(0, 1)) / static_cast<double>(windows.size());
    const bool told = random.uniform(0, 1) >= dropped_;
    const Point point = point_at(model_.path, u);
    drawn.noisy.u.push_back(u);
    drawn.noisy.labels.push_back(told ? std::optional(lesson.labels[windows[i]]) : std::nullopt);
    for (const float x : window_of(lesson, windows[i], random)) {
      const double e = random.normal(0, 1);
      drawn.noisy.windows.push_back(static_cast<float>(point.data * x + point.noise * e));
      drawn.velocities.push_back(
          static_cast<float>(point.velocity_of_data * x + point.velocity_of_noise * e));
    }
  }
  return drawn;
}

std::string DiffusionTraining::run_epoch(std::size_t epoch) {
  const Place place = place_of(epoch);
  const Lesson& lesson = lessons_[place.network];
  const Stream own = stream_.child("epoch" + std::to_string(epoch));
  Stream random = own.child("noise");
  Stream shuffle = own.child("order");
  const std::vector<std::size_t> order = shuffle.permutation(lesson.labels.size());
  const auto batch = static_cast<std::size_t>(lesson.course.batch);
  const std::size_t batches = (order.size() + batch - 1) / batch;
  double mean = 0;
  for (std::size_t i = 0; i < batches; ++i) {
    const auto windows =
        std::span(order).subspan(i * batch, std::min(batch, order.size() - i * batch));
    const Drawn drawn = draw(lesson, windows, random);
    mean += backend_->step(place.network, drawn.noisy, drawn.velocities,
                           rate_at(lesson.course, place.epoch)) /
            static_cast<double>(batches);
  }
  const nets::LearningRate rate{.value = lesson.course.learning_rate,
                                .option = lesson.course.rate_option};
  nets::require_finite(mean, "training", epoch + 1, rate);
  // The error is that before each step, so only the parameters show what the last step did.
  if (epoch + 1 == epochs() && !are_finite(backend_->values())) {
    nets::throw_diverged("training", epoch + 1, rate);
  }
  squared_errors_.push_back(mean);
  return fmt::format("squared error {:.3f}", mean);
}

void DiffusionTraining::write_state(artefact::Writer& writer) const {
  nets::write_parameters(writer, weights_group, backend_->specs(), backend_->values());
  writer.numbers("/curves/squared_error", squared_errors_);
  backend_->write_adam(writer);
}

void DiffusionTraining::read_state(const artefact::Reader& reader) {
  backend_->set_values(nets::read_parameters(reader, weights_group, backend_->specs()));
  squared_errors_ = reader.numbers<double>("/curves/squared_error", {0}).values;
  backend_->read_adam(reader);
}

void DiffusionTraining::write_model(artefact::Writer& writer) const {
  write(writer, model_);
  write_state(writer);
}

}  // namespace piae::diffusion
