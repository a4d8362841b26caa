#include "phase/training.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "base/error.hpp"
#include "phase/class_cycle.hpp"
#include "phase/generation.hpp"
#include "support/checkpoints.hpp"
#include "support/folder.hpp"
#include "support/simulated_windows.hpp"
#include "twin/one_core_backend.hpp"

namespace piae::phase {
namespace {

namespace fs = std::filesystem;

PhaseOptions quick_options() {
  PhaseOptions options;
  options.twin.epochs = 4;
  options.twin.width = 16;
  options.inference.simulations = 12;
  options.inference.epochs = 3;
  options.inference.width = 16;
  return options;
}

fs::path train(const nets::Checkpoint& checkpoint, const std::string& name) {
  const signal::WindowSet known = simulated_windows(5, "known");
  const auto training = make_phase_training(known, quick_options(), Stream("test"),
                                            twin::one_core_engine(Device::cpu));
  nets::run_epochs(*training, checkpoint);
  artefact::Writer writer("model");
  training->write_model(writer);
  fs::path path = scratch_file(name);
  writer.save(path, {});
  return path;
}

// Cuts within the first round, at its end, within the second, at its end, and within the twin's
// training.
TEST(PhaseTraining, ContinuedTrainingEqualsAnUninterruptedOne) {
  const std::string uncut = bytes_of(train(checkpoint_at("uncut.ckpt"), "uncut.h5"));
  for (const int cut : {1, 3, 5, 6, 8}) {
    nets::Checkpoint checkpoint = checkpoint_at("cut.ckpt");
    int calls = 0;
    checkpoint.interrupted = [&] { return ++calls == cut; };
    EXPECT_THROW(train(checkpoint, "never.h5"), Error) << cut;
    checkpoint.interrupted = [] { return false; };
    EXPECT_EQ(bytes_of(train(checkpoint, "continued.h5")), uncut) << cut;
  }
}

/// Two classes, with 4 simulations each in the first round and 12 in the second; 10 known windows.
/// The estimate of the remaining time uses the effort, so each part must count its own work.
TEST(PhaseTraining, EffortMatchesTheWorkOfAnEpoch) {
  const auto training = make_phase_training(simulated_windows(5, "known"), quick_options(),
                                            Stream("test"), twin::one_core_engine(Device::cpu));
  ASSERT_EQ(training->epochs(), 10U);
  EXPECT_EQ(training->effort(1), 8);
  EXPECT_EQ(training->effort(4), 24);
  // The first epochs of the rounds also simulate, which costs a fixed multiple of learning once.
  EXPECT_GT(training->effort(0), 10 * training->effort(1));
  EXPECT_EQ(training->effort(3) / training->effort(4), training->effort(0) / training->effort(1));
  EXPECT_EQ(training->effort(6), training->effort(9));
  EXPECT_GT(training->effort(9), 10);
}

TEST(PhaseGeneration, FirstWindowsDoNotDependOnTheirNumber) {
  const artefact::Reader model(train(checkpoint_at("model.ckpt"), "model.h5"), "model");
  const signal::WindowSet few =
      generate(model, 2, Stream("generate"), twin::one_core_engine(Device::cpu));
  const signal::WindowSet many =
      generate(model, 7, Stream("generate"), twin::one_core_engine(Device::cpu));
  ASSERT_EQ(few.size(), 4U);
  ASSERT_EQ(many.size(), 14U);
  for (std::size_t i = 0; i < few.length; ++i) {
    // A matrix product with more rows may round differently.
    ASSERT_NEAR(few.window(1)[i], many.window(1)[i], 1e-3) << i;
    ASSERT_NEAR(few.window(2)[i], many.window(7)[i], 1e-3) << i;
  }
}

// Window 1 of a class draws its two states and its start on the cycle from its own child of the
// stream.
TEST(PhaseGeneration, StoresTheStartAngleOfEachWindow) {
  const artefact::Reader model(train(checkpoint_at("said.ckpt"), "said.h5"), "model");
  const signal::WindowSet windows =
      generate(model, 40, Stream("generate"), twin::one_core_engine(Device::cpu));
  ASSERT_EQ(windows.start_angle_rad.size(), windows.size());
  EXPECT_TRUE(windows.parents.empty());  // states are drawn and do not belong to one window
  for (const Label label : {1, 2}) {
    const signal::Cycle cycle = cycle_of_class(bearing_info(), label, 1024);
    const double step_rad = 2 * std::numbers::pi * static_cast<double>(cycle.impacts) /
                            static_cast<double>(cycle.samples);
    double largest = 0;
    for (const std::size_t i : windows.indices_of(label)) {
      const double angle = windows.start_angle_rad[i];
      EXPECT_GE(angle, 0);
      EXPECT_LT(angle, 2 * std::numbers::pi);
      // A sample of the cycle lies at a whole number of steps, modulo whole turns: some turn must
      // fit.
      double nearest = 1;
      for (std::size_t turn = 0; turn < cycle.impacts; ++turn) {
        const double steps = (angle + 2 * std::numbers::pi * static_cast<double>(turn)) / step_rad;
        nearest = std::min(nearest, std::abs(steps - std::round(steps)));
      }
      EXPECT_LT(nearest, 1e-6);
      largest = std::max(largest, angle);
    }
    EXPECT_GT(largest, std::numbers::pi);  // 40 uniform angles are all below pi in 1 of 10^12 cases
  }
}

// Uses a trained decoder. A start j samples later gives the same window j samples earlier, bit for
// bit, before and after the change of state. A start one cycle later gives the same window.
TEST(PhaseGeneration, StartAngleShiftsTheDecoderOutput) {
  const artefact::Reader model(train(checkpoint_at("angle.ckpt"), "angle.h5"), "model");
  constexpr Label outer = 2;
  constexpr std::size_t length = 1024;
  constexpr std::size_t change = 600;
  const signal::Cycle cycle = cycle_of_class(bearing_info(), outer, length);
  const Draw draw{{1.1e8, 450}, {0.9e8, 600}, {37, change, 3}};
  std::vector<Draw> draws{draw};
  for (const std::size_t later : {1U, 250U}) {
    draws.push_back(draw);
    draws.back().passage.start += later;
  }
  draws.push_back(draw);
  draws.back().passage.start += cycle.samples;
  const std::vector<float> windows =
      decode(model, outer, draws, twin::one_core_engine(Device::cpu));
  ASSERT_EQ(windows.size(), draws.size() * length);
  const auto window = [&](std::size_t i) { return std::span(windows).subspan(i * length, length); };
  EXPECT_GT(*std::ranges::max_element(window(0)), *std::ranges::min_element(window(0)));
  for (const std::size_t i : {1U, 2U}) {
    const std::size_t later = draws[i].passage.start - draw.passage.start;
    for (std::size_t t = 0; t + later < length; ++t) {
      if (t < change && t + later >= change) continue;
      ASSERT_EQ(window(i)[t], window(0)[t + later]) << "start " << later << " later, sample " << t;
    }
  }
  EXPECT_TRUE(std::ranges::equal(window(3), window(0)));
}

TEST(PhaseTraining, RefusesWindowsThatAreTooShort) {
  signal::WindowSet known = simulated_windows(5, "known");
  known.length = 64;
  EXPECT_THROW(make_phase_training(known, quick_options(), Stream("test"),
                                   twin::one_core_engine(Device::cpu)),
               Error);
}

}  // namespace
}  // namespace piae::phase
