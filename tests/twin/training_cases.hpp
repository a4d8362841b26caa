#pragma once

// Cases that hold for the training of a twin by any engine. The test of each engine includes these
// cases and instantiates them.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "support/checkpoints.hpp"
#include "support/folder.hpp"
#include "support/known_windows.hpp"
#include "twin/backend.hpp"
#include "twin/curves.hpp"
#include "twin/generation.hpp"
#include "twin/training.hpp"

namespace piae::twin {

/// Returns options for six epochs of a small network.
inline TwinOptions quick_options() {
  TwinOptions options;
  options.epochs = 6;
  options.width = 16;
  return options;
}

/// A variant of the twin and its engine, with a name for the test.
struct NamedVariant {
  const char* name;
  TwinVariant variant;
  MakeEngine engine;
};

/// Trains with the checkpoint and returns the stored model.
inline std::filesystem::path train(const nets::Checkpoint& checkpoint, const TwinOptions& options,
                                   const std::string& name, const TwinVariant& variant,
                                   MakeEngine engine) {
  const auto training =
      make_twin_training(known_windows(), options, variant, Stream("test"), engine(Device::cpu));
  nets::run_epochs(*training, checkpoint);
  artefact::Writer writer("model");
  training->write_model(writer);
  std::filesystem::path path = scratch_file(name);
  writer.save(path, {});
  return path;
}

inline std::string name_of(const testing::TestParamInfo<NamedVariant>& info) {
  return info.param.name;
}

class TwinVariantTraining : public testing::TestWithParam<NamedVariant> {};

TEST_P(TwinVariantTraining, ContinuedTrainingEqualsAnUninterruptedOne) {
  const auto& [_, variant, engine] = GetParam();
  const TwinOptions options = quick_options();
  const std::string uncut =
      bytes_of(train(checkpoint_at("uncut.ckpt"), options, "uncut.h5", variant, engine));
  for (int cut = 1; cut <= options.epochs; ++cut) {
    nets::Checkpoint checkpoint = checkpoint_at("cut.ckpt");
    int calls = 0;
    checkpoint.interrupted = [&] { return ++calls == cut; };
    try {
      train(checkpoint, options, "never.h5", variant, engine);
      FAIL() << "was not interrupted after epoch " << cut;
    } catch (const Error& error) {
      EXPECT_EQ(error.exit(), Exit::interrupted);
    }
    checkpoint.interrupted = [] { return false; };
    EXPECT_EQ(bytes_of(train(checkpoint, options, "continued.h5", variant, engine)), uncut)
        << "cut after " << cut;
  }
}

TEST_P(TwinVariantTraining, LowersItsLosses) {
  TwinOptions options = quick_options();
  options.epochs = 120;
  options.learning_rate = 4e-3;
  options.width = 64;
  // With so few windows, the MMD of a single class would hide the learning.
  options.batches = Batches::mixed;
  Curves curves;
  curves.read(artefact::Reader(train(checkpoint_at("learn.ckpt"), options, "learn.h5",
                                     GetParam().variant, GetParam().engine),
                               "model"));
  EXPECT_LT(curves.reconstruction.back(), 0.8 * curves.reconstruction.front());
  if (GetParam().variant.physics) {
    EXPECT_LT(curves.differential.back(), 0.5 * curves.differential.front());
  }
}

TEST_P(TwinVariantTraining, GeneratesWithTheTrainedNetworks) {
  const auto& [_, variant, engine] = GetParam();
  const std::filesystem::path path =
      train(checkpoint_at("g.ckpt"), quick_options(), "generate.h5", variant, engine);
  const artefact::Reader model(path, "model");
  const signal::WindowSet few = generate(model, variant, 2, Stream("g"), engine(Device::cpu));
  const signal::WindowSet many = generate(model, variant, 7, Stream("g"), engine(Device::cpu));
  ASSERT_EQ(few.size(), 4U);  // two fault classes
  ASSERT_EQ(many.size(), 14U);
  for (const auto& [i, same] :
       {std::pair<std::size_t, std::size_t>{0, 0}, {1, 1}, {2, 7}, {3, 8}}) {
    EXPECT_GT(few.parameters[i].stiffness_n_per_m, 0);
    EXPECT_EQ(few.parameters[i].stiffness_n_per_m, many.parameters[same].stiffness_n_per_m);
    for (std::size_t t = 0; t < few.length; ++t) {
      EXPECT_NEAR(few.window(i)[t], many.window(same)[t], 1e-5);
    }
  }

  TwinOptions longer = quick_options();
  longer.epochs = 12;
  const artefact::Reader other(train(checkpoint_at("h.ckpt"), longer, "longer.h5", variant, engine),
                               "model");
  const signal::WindowSet others = generate(other, variant, 2, Stream("g"), engine(Device::cpu));
  for (std::size_t i = 0; i < few.size(); ++i) {
    EXPECT_FALSE(std::ranges::equal(few.window(i), others.window(i))) << i;
  }
}

}  // namespace piae::twin
