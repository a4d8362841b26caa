#include <fstream>

#include "support/errors.hpp"
#include "support/three_classes.hpp"
#include "twin/model.hpp"
#include "twin/one_core_backend.hpp"
#include "twin/space.hpp"
#include "twin/training_cases.hpp"

namespace piae::twin {
namespace {

namespace fs = std::filesystem;

const NamedVariant variants[] = {{"Full", full_model, one_core_engine},
                                 {"WithoutPhysics", without_physics, one_core_engine},
                                 {"Convolutional", convolutional_model, one_core_engine},
                                 {"Recurrent", recurrent_model, one_core_engine},
                                 {"Temporal", temporal_model, one_core_engine},
                                 {"Transformer", transformer_model, one_core_engine}};
INSTANTIATE_TEST_SUITE_P(OneCore, TwinVariantTraining, testing::ValuesIn(variants), name_of);

fs::path train(const nets::Checkpoint& checkpoint, const TwinOptions& options,
               const std::string& name, const TwinVariant& variant = full_model) {
  return train(checkpoint, options, name, variant, one_core_engine);
}

TEST(TwinGeneration, RefusesAModelWithoutTheNetworksOfTheVariant) {
  const artefact::Reader model(
      train(checkpoint_at("v.ckpt"), quick_options(), "v.h5", without_physics), "model");
  EXPECT_THROW(generate(model, full_model, 1, Stream("g"), one_core_engine(Device::cpu)),
               artefact::Refusal);
}

TEST(TwinGeneration, RefusesAModelWithImpossibleSizes) {
  TwinOptions options = quick_options();
  options.depth = 1;
  const artefact::Reader model(train(checkpoint_at("d.ckpt"), options, "shallow.h5"), "model");
  EXPECT_ERROR(generate(model, convolutional_model, 1, Stream("g"), one_core_engine(Device::cpu)),
               Exit::bad_input, "has impossible network sizes: --depth: 1 leaves no convolution");
}

TEST(TwinTraining, GivesTheSameBytesTwice) {
  const fs::path first = train(checkpoint_at("a.ckpt"), quick_options(), "first.h5");
  const fs::path second = train(checkpoint_at("b.ckpt"), quick_options(), "second.h5");
  EXPECT_EQ(bytes_of(first), bytes_of(second));
}

TEST(TwinTraining, WithoutPhysicsFollowsTheReconstructionLossOnly) {
  TwinOptions options = quick_options();
  const auto model_of = [&](const std::string& name) {
    return artefact::Reader(train(checkpoint_at("p.ckpt"), options, name, without_physics),
                            "model");
  };
  const artefact::Reader model = model_of("ae.h5");
  EXPECT_TRUE(model.has("/final/net/decoder/0/weight"));
  EXPECT_FALSE(model.has("/final/net/physics/0/weight"));
  Curves curves;
  curves.read(model);
  EXPECT_EQ(curves.total, curves.reconstruction);
  const std::vector<double> zeros(6, 0.0);
  const std::vector<double> ones(6, 1.0);
  EXPECT_EQ(curves.differential, zeros);
  EXPECT_EQ(curves.twin, zeros);
  EXPECT_EQ(curves.alpha, ones);
  EXPECT_EQ(curves.gamma, ones);

  // Options without an effect on this variant must change nothing, and are not stored.
  options.mass_kg = 3;
  options.clearance_um = 7;
  options.loss_weights = LossWeights::fixed;
  Curves same;
  same.read(model_of("heavy.h5"));
  EXPECT_EQ(same.reconstruction, curves.reconstruction);
}

TEST(TwinTraining, HoldsFixedLossWeightsAtOne) {
  TwinOptions options = quick_options();
  options.loss_weights = LossWeights::fixed;
  Curves curves;
  curves.read(artefact::Reader(train(checkpoint_at("f.ckpt"), options, "fixed.h5"), "model"));
  const std::vector<double> ones(6, 1.0);
  EXPECT_EQ(curves.alpha, ones);
  EXPECT_EQ(curves.beta, ones);
  EXPECT_EQ(curves.gamma, ones);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(curves.total[i], curves.reconstruction[i] + curves.differential[i] + curves.twin[i],
                1e-5);
  }
}

/// The minimum of eq. 23 in a weight is at 1 / (2 L).
TEST(TwinTraining, WeighsLossesAtTheStationaryPointOfThePreviousEpoch) {
  TwinOptions options = quick_options();
  options.loss_weights = LossWeights::stationary;
  Curves curves;
  curves.read(artefact::Reader(train(checkpoint_at("s.ckpt"), options, "stationary.h5"), "model"));
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(2 * curves.alpha[i] * curves.differential[i], 1, 1e-5);
    EXPECT_NEAR(2 * curves.beta[i] * curves.twin[i], 1, 1e-5);
    EXPECT_NEAR(2 * curves.gamma[i] * curves.reconstruction[i], 1, 1e-5);
  }
}

TEST(TwinTraining, StoresTheFinalStationaryWeights) {
  const artefact::Reader model(train(checkpoint_at("o.ckpt"), quick_options(), "outcome.h5"),
                               "model");
  Curves curves;
  curves.read(model);
  EXPECT_DOUBLE_EQ(model.real("/curves", "alpha_stationary"), 0.5 / curves.differential.back());
  EXPECT_DOUBLE_EQ(model.real("/curves", "beta_stationary"), 0.5 / curves.twin.back());
  EXPECT_DOUBLE_EQ(model.real("/curves", "gamma_stationary"), 0.5 / curves.reconstruction.back());
}

/// Eq. 23 without its logarithms always rewards smaller weights.
TEST(TwinTraining, WithoutTheLogarithmsAllLossWeightsShrink) {
  TwinOptions options = quick_options();
  options.loss_weights = LossWeights::adaptive_without_log;
  Curves curves;
  curves.read(artefact::Reader(train(checkpoint_at("n.ckpt"), options, "nolog.h5"), "model"));
  for (const auto weight : {&Curves::alpha, &Curves::beta, &Curves::gamma}) {
    EXPECT_LT((curves.*weight)[1], 1);
    EXPECT_LT((curves.*weight)[5], (curves.*weight)[1]);
    EXPECT_GT((curves.*weight)[5], 0);
  }
}

TEST(TwinTraining, IgnoresACheckpointOfOtherSettings) {
  nets::Checkpoint checkpoint = checkpoint_at("other.ckpt");
  checkpoint.interrupted = [] { return true; };
  EXPECT_THROW(train(checkpoint, quick_options(), "never.h5"), Error);
  checkpoint.interrupted = [] { return false; };
  checkpoint.provenance.options = "epochs = \"7\"\n";
  const std::string uncut =
      bytes_of(train(checkpoint_at("uncut.ckpt"), quick_options(), "uncut.h5"));
  EXPECT_EQ(bytes_of(train(checkpoint, quick_options(), "anew.h5")), uncut);
}

TEST(TwinTraining, StartsAgainAfterADamagedCheckpoint) {
  nets::Checkpoint checkpoint = checkpoint_at("damaged.ckpt");
  std::ofstream(checkpoint.path) << "not a checkpoint";
  const std::string uncut =
      bytes_of(train(checkpoint_at("uncut.ckpt"), quick_options(), "uncut.h5"));
  EXPECT_EQ(bytes_of(train(checkpoint, quick_options(), "anew.h5")), uncut);
}

TEST(TwinTraining, StageOneKeepsTheLossWeights) {
  TwinOptions options = quick_options();
  options.stage_epochs = 2;  // Stage 1, 1, 2, 2, 1, 1
  Curves curves;
  curves.read(artefact::Reader(train(checkpoint_at("w.ckpt"), options, "weights.h5"), "model"));
  EXPECT_EQ(curves.alpha[0], 1);
  EXPECT_EQ(curves.alpha[1], 1);
  EXPECT_NE(curves.alpha[2], 1);
  EXPECT_NE(curves.alpha[3], curves.alpha[2]);
  EXPECT_EQ(curves.alpha[4], curves.alpha[3]);
}

TEST(TwinTraining, HalvesTheLearningRate) {
  TwinOptions options = quick_options();
  options.decay_every = 2;
  Curves curves;
  curves.read(artefact::Reader(train(checkpoint_at("lr.ckpt"), options, "rate.h5"), "model"));
  EXPECT_EQ(curves.learning_rate,
            (std::vector<double>{5e-4, 5e-4, 2.5e-4, 2.5e-4, 1.25e-4, 1.25e-4}));
}

TEST(TwinTraining, RefusesWindowsTooShortForASecondDerivative) {
  const signal::WindowSet windows = known_windows(2);
  try {
    make_twin_training(windows, quick_options(), full_model, Stream("test"),
                       one_core_engine(Device::cpu));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::usage);
    EXPECT_NE(std::string(error.what()).find("3 or more"), std::string::npos) << error.what();
  }
}

TEST(TwinTraining, RefusesAConstantClass) {
  signal::WindowSet windows = known_windows();
  std::fill(windows.samples.begin(), windows.samples.begin() + std::ptrdiff_t{5} * 64, 1.0F);
  EXPECT_THROW(make_twin_training(windows, quick_options(), full_model, Stream("test"),
                                  one_core_engine(Device::cpu)),
               Error);
}

TEST(TwinGeneration, DrawsFromTheTwinSpace) {
  const fs::path path = train(checkpoint_at("s.ckpt"), quick_options(), "space.h5");
  const artefact::Reader model(path, "model");
  const TwinSpace space(model);
  for (const auto& parameters :
       generate(model, full_model, 50, Stream("g"), one_core_engine(Device::cpu)).parameters) {
    EXPECT_GE(parameters.stiffness_n_per_m, space.k_edges().front() * 1e8);
    EXPECT_LE(parameters.stiffness_n_per_m, space.k_edges().back() * 1e8);
    EXPECT_GE(parameters.damping_ns_per_m, space.c_edges().front() * 1e2);
    EXPECT_LE(parameters.damping_ns_per_m, space.c_edges().back() * 1e2);
  }
}

TEST(TwinGeneration, DependsOnTheKeptModel) {
  TwinOptions options = quick_options();
  const fs::path best = train(checkpoint_at("k1.ckpt"), options, "best.h5");
  options.keep = Keep::final;
  const fs::path last = train(checkpoint_at("k2.ckpt"), options, "final.h5");
  const artefact::Reader best_model(best, "model");
  const artefact::Reader final_model(last, "model");
  for (const std::string group : {"/best", "/final"}) {
    const std::string weight = group + "/net/decoder/0/weight";
    EXPECT_EQ(best_model.numbers<float>(weight, {0, 0}).values,
              final_model.numbers<float>(weight, {0, 0}).values);
  }
  const bool last_is_best = best_model.integer("/", "best_epoch") == options.epochs;
  const auto a =
      generate(best_model, full_model, 3, Stream("g"), one_core_engine(Device::cpu)).samples;
  const auto b =
      generate(final_model, full_model, 3, Stream("g"), one_core_engine(Device::cpu)).samples;
  EXPECT_EQ(a == b, last_is_best);
}

// The model may come from another version or from an edit by hand.
TEST(TwinModel, RefusesAnUnknownKeepByName) {
  artefact::Writer writer("model");
  signal::write(writer, three_classes());
  for (const std::string name : {"samples", "depth", "width"}) {
    writer.attribute("/", name, std::int64_t{16});
  }
  writer.attribute("/", "keep", std::string("newest"));
  writer.numbers("/classes/acceleration", std::vector<double>{1, 1, 1});
  const fs::path path = scratch_file("newest.h5");
  writer.save(path, {});
  const artefact::Reader model(path, "model");
  EXPECT_ERROR(read_model_description(model), Exit::bad_input, "is 'newest'; known: best, final");
}

}  // namespace
}  // namespace piae::twin
