#include "diffusion/model.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "diffusion/training.hpp"
#include "signal/amplitude.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"
#include "support/impact_windows.hpp"

namespace piae::diffusion {
namespace {

/// Knows the law of the data: independent samples from N(mean, deviation^2), where the mean is that
/// of the class, or 0 if it is not told. Its velocity is the conditional expectation.
class NormalLaw final : public DiffusionBackend {
 public:
  NormalLaw(Path path, std::vector<double> means, double deviation)
      : path_(path), means_(std::move(means)), deviation_(deviation) {}

  std::vector<float> velocities(const NoisyBatch& batch, std::size_t /*networks*/) override {
    std::vector<float> velocities(batch.windows.size());
    const std::size_t length = batch.windows.size() / batch.u.size();
    for (std::size_t i = 0; i < velocities.size(); ++i) {
      const auto& label = batch.labels[i / length];
      const double mean = label ? means_[index_of(*label)] : 0;
      const Point point = point_at(path_, batch.u[i / length]);
      // x = a x0 + b e with x0 = mean + deviation z: both are jointly normal.
      const double variance = std::pow(point.data * deviation_, 2) + std::pow(point.noise, 2);
      const double rest = (batch.windows[i] - point.data * mean) / variance;
      const double window = mean + point.data * deviation_ * deviation_ * rest;
      const double noise = point.noise * rest;
      velocities[i] =
          static_cast<float>(point.velocity_of_data * window + point.velocity_of_noise * noise);
    }
    return velocities;
  }
  double step(std::size_t, const NoisyBatch&, std::span<const float>, double) override { return 0; }
  [[nodiscard]] const std::vector<nets::ParameterSpec>& specs() const override { return specs_; }
  [[nodiscard]] std::vector<float> values() const override { return {}; }
  void set_values(std::span<const float> /*values*/) override {}
  void write_adam(artefact::Writer& /*writer*/) const override {}
  void read_adam(const artefact::Reader& /*reader*/) override {}

 private:
  Path path_;
  std::vector<double> means_;
  double deviation_;
  std::vector<nets::ParameterSpec> specs_;
};

DiffusionModel example_model(Path path, int steps, double guidance = 0) {
  DiffusionModel model{.info = three_classes(),
                       .path = path,
                       .networks = networks_of(64, 3, {{.channels = 16, .blocks = 1}}),
                       .steps = steps,
                       .guidance = guidance,
                       .rms = {1, 2, 3}};
  return model;
}

std::vector<float> normal_noise(std::size_t count) {
  Stream stream("noise");
  std::vector<float> noise(count);
  for (float& e : noise) e = static_cast<float>(stream.normal(0, 1));
  return noise;
}

// The velocity that is the conditional expectation carries N(0, 1) to N(mean, deviation^2): each
// number to mean + deviation e.
TEST(FollowedPath, CarriesNoiseToTheLawOfTheData) {
  const std::vector<float> noise = normal_noise(2 * 64);
  for (const Path path : {Path::diffusion, Path::flow}) {
    NormalLaw law(path, {0, 1.5, -2}, 0.6);
    const std::vector<float> made = follow(example_model(path, 400), law, 1, noise);
    for (std::size_t i = 0; i < noise.size(); ++i) {
      EXPECT_NEAR(made[i], 1.5 + 0.6 * noise[i], 0.02) << i;
    }
  }
}

// Euler's method would miss by up to 0.3.
TEST(FollowedPath, OfAFlowNeedsOnlyEightSteps) {
  const std::vector<float> noise = normal_noise(2 * 64);
  NormalLaw law(Path::flow, {0, 1.5, -2}, 0.6);
  const std::vector<float> made = follow(example_model(Path::flow, 8), law, 1, noise);
  for (std::size_t i = 0; i < noise.size(); ++i) {
    EXPECT_NEAR(made[i], 1.5 + 0.6 * noise[i], 0.03) << i;
  }
}

// Guidance moves the mean from that of all windows (0) past that of the class.
TEST(FollowedPath, GoesBeyondTheClassWithGuidance) {
  NormalLaw law(Path::flow, {0, 1.5, -2}, 0.6);
  const auto mean = [&](double guidance) {
    const auto made =
        follow(example_model(Path::flow, 100, guidance), law, 2, std::vector<float>(64, 0.0F));
    return made.front();
  };
  EXPECT_NEAR(mean(0), -2, 0.05);
  EXPECT_NEAR(mean(1), -4, 0.1);
}

class StoredDiffusion : public testing::Test {
 protected:
  artefact::Reader stored(const DiffusionModel& model) {
    std::vector<Lesson> lessons;
    signal::WindowSet set = no_impact_windows(64);
    Stream stream("few");
    for (const Label label : {1, 2}) add_impact_windows(set, label, 1, stream);
    for (std::size_t i = 0; i < model.networks.size(); ++i) {
      lessons.push_back(lesson_of(set, signal::rms_by_class(set), Angle::known,
                                  {.epochs = 1, .batch = 2, .learning_rate = 1e-3}));
    }
    DiffusionTraining training(
        model, std::move(lessons), 0, Stream("toy"),
        [](const Networks& networks, std::int64_t most, const Stream& initial) {
          return one_core_diffusion(networks, most, initial, Device::cpu);
        });
    training.run_epoch(0);
    artefact::Writer writer("model");
    training.write_model(writer);
    writer.save(folder_ / "model.h5", {});
    return {folder_ / "model.h5", "model"};
  }
  const Folder folder_;
};

TEST_F(StoredDiffusion, IsReadAsItWasWritten) {
  DiffusionModel model = example_model(Path::flow, 8, 0.5);
  model.networks =
      networks_of(64, 3, {{.channels = 32, .blocks = 2}, {.channels = 16, .blocks = 1}});
  const DiffusionModel read = read_diffusion_model(stored(model));
  EXPECT_EQ(read.path, Path::flow);
  EXPECT_EQ(read.steps, 8);
  EXPECT_EQ(read.guidance, 0.5);
  EXPECT_EQ(read.rms, model.rms);
  ASSERT_EQ(read.networks.size(), 2U);
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_EQ(read.networks[i].name, model.networks[i].name);
    EXPECT_EQ(read.networks[i].samples, 64);
    EXPECT_EQ(read.networks[i].classes, i == 0 ? 0 : 3);
    EXPECT_EQ(read.networks[i].size.channels, model.networks[i].size.channels);
    EXPECT_EQ(read.networks[i].size.blocks, model.networks[i].size.blocks);
  }
}

TEST_F(StoredDiffusion, MakesTheSameWindowsInLargerSets) {
  const artefact::Reader model = stored(example_model(Path::diffusion, 3));
  const auto made = [&](std::size_t count) {
    return generate(model, count, Stream("made"), one_core_diffusion, Device::cpu);
  };
  const signal::WindowSet few = made(2);
  const signal::WindowSet many = made(40);  // in two parts
  ASSERT_EQ(few.labels, (std::vector<Label>{1, 1, 2, 2}));
  ASSERT_EQ(many.size(), 80U);
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_TRUE(std::ranges::equal(few.window(i), many.window(i)));
    EXPECT_TRUE(std::ranges::equal(few.window(2 + i), many.window(40 + i)));
  }
  EXPECT_EQ(made(0).size(), 0U);
}

TEST_F(StoredDiffusion, RefusesSizesThatNoNetworkHas) {
  const auto refused = [&](int channels, std::int64_t samples, const std::string& why) {
    DiffusionModel model = example_model(Path::flow, 3);
    model.networks = networks_of(samples, 3, {{.channels = channels, .blocks = 1}});
    artefact::Writer writer("model");
    write(writer, model);
    writer.save(folder_ / "other.h5", {});
    EXPECT_ERROR(read_diffusion_model({folder_ / "other.h5", "model"}), Exit::bad_input, why);
  };
  refused(17, 64, "holds 17, which is not a multiple of 16");
  refused(0, 64, "/networks/channels");
  refused(16, 60, "samples is 60, not whole frames of 16");
}

TEST_F(StoredDiffusion, RefusesAnUnknownPath) {
  artefact::Writer writer("model");
  signal::write(writer, three_classes());
  writer.attribute("/", "path", std::string("detour"));
  writer.save(folder_ / "other.h5", {});
  EXPECT_ERROR(read_diffusion_model({folder_ / "other.h5", "model"}), Exit::bad_input,
               "path is 'detour', but diffusion and flow are known");
}

}  // namespace
}  // namespace piae::diffusion
