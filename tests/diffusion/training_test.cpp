#include "diffusion/training.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include "signal/amplitude.hpp"
#include "support/errors.hpp"
#include "support/impact_windows.hpp"

namespace piae::diffusion {
namespace {

constexpr Course short_course{.epochs = 3, .batch = 4, .learning_rate = 1e-3};
constexpr DenoiserSize small{.channels = 16, .blocks = 1};

signal::WindowSet impacts() {
  signal::WindowSet set = no_impact_windows();
  Stream stream("impacts");
  for (const Label label : {1, 2}) add_impact_windows(set, label, 3, stream);
  return set;
}

DiffusionModel model_of(const signal::WindowSet& set, std::size_t networks) {
  return {.info = set.info,
          .path = Path::diffusion,
          .networks = networks_of(static_cast<std::int64_t>(set.length),
                                  std::ssize(set.info.classes), std::vector(networks, small)),
          .steps = 5,
          .guidance = 0,
          .rms = {1, 1, 1}};
}

/// Records what it is given and learns nothing.
class Recorder final : public DiffusionBackend {
 public:
  struct Step {
    std::size_t trained;
    NoisyBatch batch;
    std::vector<float> velocities;
    double learning_rate;
  };
  explicit Recorder(std::vector<Step>& steps) : steps_(steps) {}

  std::vector<float> velocities(const NoisyBatch& batch, std::size_t /*networks*/) override {
    return batch.windows;
  }
  double step(std::size_t trained, const NoisyBatch& batch, std::span<const float> velocities,
              double learning_rate) override {
    steps_.push_back({trained, batch, {velocities.begin(), velocities.end()}, learning_rate});
    return 1;
  }
  [[nodiscard]] const std::vector<nets::ParameterSpec>& specs() const override { return specs_; }
  [[nodiscard]] std::vector<float> values() const override { return {}; }
  void set_values(std::span<const float> /*values*/) override {}
  void write_adam(artefact::Writer& /*writer*/) const override {}
  void read_adam(const artefact::Reader& /*reader*/) override {}

 private:
  std::vector<Step>& steps_;
  std::vector<nets::ParameterSpec> specs_;
};

std::vector<Recorder::Step> steps_of(const signal::WindowSet& set, std::vector<Lesson> lessons,
                                     double dropped = 0) {
  std::vector<Recorder::Step> steps;
  const std::size_t networks = lessons.size();
  DiffusionTraining training(model_of(set, networks), std::move(lessons), dropped, Stream("toy"),
                             [&](const Networks&, std::int64_t most, const Stream&) {
                               EXPECT_EQ(most, 4);
                               return std::make_unique<Recorder>(steps);
                             });
  for (std::size_t epoch = 0; epoch < training.epochs(); ++epoch) training.run_epoch(epoch);
  return steps;
}

Lesson lesson(const signal::WindowSet& set, Angle angle = Angle::known) {
  return lesson_of(set, signal::rms_by_class(set), angle, short_course);
}

TEST(DiffusionTraining, TeachesOneNetworkAfterTheOther) {
  const signal::WindowSet set = impacts();
  const auto steps = steps_of(set, {lesson(set), lesson(set)});
  ASSERT_EQ(steps.size(), 12U);  // 2 lessons of 3 epochs, 6 windows in batches of 4
  for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(steps[i].trained, i / 6);
  EXPECT_EQ(steps[0].batch.size(), 4);
  EXPECT_EQ(steps[1].batch.size(), 2);
}

TEST(DiffusionTraining, LowersTheLearningRateByHalfACosine) {
  const signal::WindowSet set = impacts();
  const auto steps = steps_of(set, {lesson(set)});
  for (std::size_t epoch = 0; epoch < 3; ++epoch) {
    const double done = (static_cast<double>(epoch) + 0.5) / 3;
    EXPECT_NEAR(steps[2 * epoch].learning_rate,
                1e-3 * std::pow(std::cos(std::numbers::pi * done / 2), 2), 1e-12);
  }
}

/// Runs one epoch with our own back end, at a learning rate at which numbers overflow.
void diverge(Course course, std::size_t networks) {
  const signal::WindowSet set = impacts();
  course.epochs = 1;
  std::vector<Lesson> lessons(networks,
                              lesson_of(set, signal::rms_by_class(set), Angle::known, course));
  DiffusionTraining training(model_of(set, networks), std::move(lessons), 0, Stream("toy"),
                             [](const Networks& all, std::int64_t most, const Stream& initial) {
                               return one_core_diffusion(all, most, initial, Device::cpu);
                             });
  for (std::size_t epoch = 0; epoch < training.epochs(); ++epoch) training.run_epoch(epoch);
}

TEST(DiffusionTraining, NamesTheLearningRateThatMadeItDiverge) {
  Course course{.batch = 4, .learning_rate = 1e38};
  EXPECT_ERROR(diverge(course, 1), Exit::failed, "with --learning-rate 1e+38");
  course.rate_option = "--healthy-learning-rate";
  EXPECT_ERROR(diverge(course, 1), Exit::failed, "with --healthy-learning-rate 1e+38");
  course.batch = 6;  // one step, whose loss is that before it
  EXPECT_ERROR(diverge(course, 1), Exit::failed, "training diverged in epoch 1");
}

// x = a x0 + b e and v = a' x0 + b' e; both together give x0, a known window of the class.
TEST(DiffusionTraining, ShowsPointsOnThePathsOfKnownWindows) {
  const signal::WindowSet set = impacts();
  const Lesson known = lesson(set);
  for (const Recorder::Step& step : steps_of(set, {known})) {
    for (std::size_t i = 0; i < step.batch.u.size(); ++i) {
      EXPECT_GE(step.batch.u[i] * static_cast<double>(step.batch.u.size()), static_cast<double>(i));
      EXPECT_LE(step.batch.u[i] * static_cast<double>(step.batch.u.size()),
                static_cast<double>(i) + 1);
      const Point point = point_at(Path::diffusion, step.batch.u[i]);
      double nearest = 1e9;
      for (std::size_t k = 0; k < set.size(); ++k) {
        if (set.labels[k] != step.batch.labels[i]) continue;
        double distance = 0;
        for (std::size_t t = 0; t < set.length; ++t) {
          const double window = point.data * step.batch.windows[i * set.length + t] -
                                point.noise * step.velocities[i * set.length + t];
          distance = std::max(distance, std::abs(window - known.windows[k * set.length + t]));
        }
        nearest = std::min(nearest, distance);
      }
      EXPECT_LT(nearest, 1e-4);
    }
  }
}

TEST(DiffusionTraining, DropsTheClassOfSomeWindows) {
  const signal::WindowSet set = impacts();
  std::size_t told = 0;
  std::size_t all = 0;
  std::vector<Lesson> lessons{lesson(set)};
  lessons.front().course.epochs = 100;
  for (const Recorder::Step& step : steps_of(set, std::move(lessons), 0.3)) {
    for (const auto& label : step.batch.labels) told += label ? 1 : 0;
    all += step.batch.labels.size();
  }
  ASSERT_EQ(all, 600U);
  EXPECT_NEAR(static_cast<double>(told) / 600, 0.7, 0.07);  // 3.7 deviations
}

// A drawn angle gives windows that are periodic with the fault cycle.
TEST(DiffusionTraining, ReadsCyclesFromARandomStart) {
  const signal::WindowSet set = impacts();
  const Lesson drawn = lesson(set, Angle::drawn);
  ASSERT_EQ(drawn.cycles.size(), set.size());
  const auto steps = steps_of(set, {drawn});
  std::set<std::size_t> starts;
  for (std::size_t i = 0; i < 4; ++i) {
    const Label label = *steps[0].batch.labels[i];
    const std::size_t length = drawn.cycles[set.indices_of(label).front()].size();
    ASSERT_LT(length, set.length);
    const Point point = point_at(Path::diffusion, steps[0].batch.u[i]);
    const auto sample = [&](std::size_t t) {
      return point.data * steps[0].batch.windows[i * set.length + t] -
             point.noise * steps[0].velocities[i * set.length + t];
    };
    for (std::size_t t = 0; t + length < set.length; ++t) {
      EXPECT_NEAR(sample(t), sample(t + length), 1e-4);
    }
    // The place in the cycle of one of the known windows at which it starts.
    std::optional<std::size_t> start;
    for (const std::size_t known : set.indices_of(label)) {
      const std::vector<float>& cycle = drawn.cycles[known];
      for (std::size_t shift = 0; shift < cycle.size(); ++shift) {
        double distance = 0;
        for (std::size_t t = 0; t < cycle.size(); ++t) {
          const float expected = cycle[(shift + t) % cycle.size()];
          distance = std::max(distance, std::abs(sample(t) - expected));
        }
        if (distance < 1e-4) start = shift;
      }
    }
    ASSERT_TRUE(start);
    starts.insert(*start);
  }
  EXPECT_GE(starts.size(), 3U);
}

TEST(ALesson, RefusesAFaultWithoutACycle) {
  signal::WindowSet set = impacts();
  set.info.classes[1].defect = signal::Defect::other;
  EXPECT_ERROR(lesson(set, Angle::drawn), Exit::bad_input, "class IR");
}

}  // namespace
}  // namespace piae::diffusion
