#include "diffusion/denoiser.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "base/random.hpp"
#include "base/vector.hpp"
#include "support/errors.hpp"

namespace piae::diffusion {
namespace {

const Denoiser example{
    .name = "net/denoiser", .samples = 64, .classes = 3, .size = {.channels = 16, .blocks = 2}};

std::vector<float> noise(std::size_t count, const std::string& name) {
  Stream stream(name);
  std::vector<float> numbers(count);
  for (float& x : numbers) x = static_cast<float>(stream.normal(0, 1));
  return numbers;
}

TEST(Denoiser, ReadsEachFrameWithThePlaceAndTheClass) {
  const std::vector<float> window = noise(64, "window");
  const std::int64_t held = whole_rows(example.inputs());
  std::vector<double> row(static_cast<std::size_t>(4 * held), 99);
  fill_input(example, window.data(), 0.5, 2, row.data());
  for (std::int64_t t = 0; t < 4; ++t) {
    const double* const frame = row.data() + t * held;
    for (std::int64_t i = 0; i < 16; ++i) {
      EXPECT_EQ(frame[i], window[static_cast<std::size_t>(16 * t + i)]);
    }
    EXPECT_NEAR(frame[16], std::sin(std::numbers::pi / 4), 1e-12);
    EXPECT_NEAR(frame[23], std::cos(2 * std::numbers::pi), 1e-12);
    EXPECT_EQ(std::vector<double>(frame + 24, frame + 27), (std::vector<double>{0, 0, 1}));
    for (std::int64_t i = 27; i < held; ++i) EXPECT_EQ(frame[i], 0);
  }
  fill_input(example, window.data(), 0.5, std::nullopt, row.data());
  EXPECT_EQ(row[26], 0);
}

TEST(Denoiser, NeedsWholeFrames) {
  require_whole_frames(1024);
  EXPECT_ERROR(require_whole_frames(1000), Exit::bad_input,
               "windows of 1000 samples are not whole frames of 16");
}

TEST(Denoiser, HasDilationsUpToHalfAWindow) {
  EXPECT_EQ(Denoiser::dilation(0), 1);
  EXPECT_EQ(Denoiser::dilation(5), 32);
  EXPECT_EQ(Denoiser::dilation(6), 1);
}

// Compares with the network written out number by number.
TEST(Denoiser, ComputesResidualBlocksOfDilatedConvolutions) {
  const auto parameters =
      std::make_shared<nets::Parameters<double>>(denoiser_specs(example), Stream("initial"));
  const auto network = make_network<double>(example, parameters, 1);
  const std::vector<float> window = noise(64, "window");
  fill_input(example, window.data(), 0.3, 1, network->input().row(0));
  const std::vector<double> input(network->input().row(0),
                                  network->input().row(0) + 4 * whole_rows(example.inputs()));
  const double* const output = network->forward(1).row(0);

  const auto all = [&](const std::string& name) {
    const auto values =
        parameters->read(nets::Parameters<double>::Kept::value, "net/denoiser/" + name);
    return std::vector<double>(values.begin(), values.end());
  };
  using Frames = std::vector<std::vector<double>>;
  Frames x(4, std::vector<double>(16));
  const std::vector<double> of_frames = all("frames/weight");
  const std::vector<double> frames_bias = all("frames/bias");
  const std::size_t inputs = static_cast<std::size_t>(example.inputs());
  for (std::size_t t = 0; t < 4; ++t) {
    for (std::size_t c = 0; c < 16; ++c) {
      x[t][c] = frames_bias[c];
      for (std::size_t i = 0; i < inputs; ++i) {
        x[t][c] += of_frames[c * inputs + i] *
                   input[t * static_cast<std::size_t>(whole_rows(example.inputs())) + i];
      }
    }
  }
  const auto convolved = [&](const Frames& from, const std::string& name, std::int64_t dilation) {
    const std::vector<double> weight = all(name + "/weight");  // [outputs, kernel, inputs]
    Frames to(4, all(name + "/bias"));
    for (std::int64_t t = 0; t < 4; ++t) {
      for (std::size_t o = 0; o < 16; ++o) {
        for (std::int64_t k = 0; k < 3; ++k) {
          const std::int64_t at = t + (k - 1) * dilation;
          if (at < 0 || at >= 4) continue;
          for (std::size_t i = 0; i < 16; ++i) {
            to[static_cast<std::size_t>(t)][o] +=
                weight[(o * 3 + static_cast<std::size_t>(k)) * 16 + i] *
                std::max(from[static_cast<std::size_t>(at)][i], 0.0);
          }
        }
      }
    }
    return to;
  };
  for (const std::int64_t block : {0, 1}) {
    const std::string name = "block" + std::to_string(block);
    const std::int64_t dilation = std::int64_t{1} << block;
    const Frames change =
        convolved(convolved(x, name + "/conv0", dilation), name + "/conv1", dilation);
    for (std::size_t t = 0; t < 4; ++t) {
      for (std::size_t c = 0; c < 16; ++c) x[t][c] += change[t][c];
    }
  }
  const std::vector<double> of_velocity = all("velocity/weight");
  const std::vector<double> velocity_bias = all("velocity/bias");
  for (std::size_t t = 0; t < 4; ++t) {
    for (std::size_t i = 0; i < 16; ++i) {
      double expected = velocity_bias[i];
      for (std::size_t c = 0; c < 16; ++c) expected += of_velocity[i * 16 + c] * x[t][c];
      EXPECT_NEAR(output[t * 16 + i], expected, 1e-6) << t << ' ' << i;
    }
  }
}

}  // namespace
}  // namespace piae::diffusion
