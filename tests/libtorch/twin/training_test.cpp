#include "twin/training.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/error.hpp"
#include "known_windows.hpp"
#include "twin/curves.hpp"
#include "twin/generation.hpp"
#include "libtorch/twin/backend.hpp"
#include "twin/dense_backend.hpp"
#include "twin/space.hpp"

namespace piae::twin {
namespace {

namespace fs = std::filesystem;

TwinOptions quick_options() {
  TwinOptions options;
  options.epochs = 6;
  options.width = 16;
  return options;
}

nets::Checkpoint checkpoint_at(const std::string& name) {
  nets::Checkpoint checkpoint;
  checkpoint.path = fs::path(testing::TempDir()) / name;
  fs::remove(checkpoint.path);
  checkpoint.interrupted = [] { return false; };
  return checkpoint;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  return bytes.str();
}

/// Trains with the checkpoint and returns the stored model.
fs::path train(const nets::Checkpoint& checkpoint, const TwinOptions& options,
               const std::string& name, const TwinVariant& variant = full_model,
               MakeEngine engine = native_engine) {
  const auto training =
      make_twin_training(known_windows(), options, variant, Stream("test"), engine("cpu"));
  nets::run_epochs(*training, checkpoint);
  artefact::Writer writer("model");
  training->write_model(writer);
  fs::path path = fs::path(testing::TempDir()) / name;
  writer.save(path, {});
  return path;
}

TEST(TwinTraining, GivesTheSameBytesTwice) {
  const fs::path first = train(checkpoint_at("a.ckpt"), quick_options(), "first.h5");
  const fs::path second = train(checkpoint_at("b.ckpt"), quick_options(), "second.h5");
  EXPECT_EQ(bytes_of(first), bytes_of(second));
}

struct NamedVariant {
  const char* name;
  TwinVariant variant;
  MakeEngine engine;
};

class TwinVariantTraining : public testing::TestWithParam<NamedVariant> {};

TEST_P(TwinVariantTraining, CutAfterAnyEpochAndContinuedEqualsAnUncutOne) {
  const auto& [_, variant, engine] = GetParam();
  const TwinOptions options = quick_options();
  const std::string uncut =
      bytes_of(train(checkpoint_at("uncut.ckpt"), options, "uncut.h5", variant, engine));
  for (int cut = 1; cut <= options.epochs; ++cut) {
    nets::Checkpoint checkpoint = checkpoint_at("cut.ckpt");
    int asked = 0;
    checkpoint.interrupted = [&] { return ++asked == cut; };
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

TEST_P(TwinVariantTraining, Learns) {
  TwinOptions options = quick_options();
  options.epochs = 60;
  options.learning_rate = 4e-3;
  options.width = 64;
  Curves curves;
  curves.read(artefact::Reader(train(checkpoint_at("learn.ckpt"), options, "learn.h5",
                                     GetParam().variant, GetParam().engine),
                               "model"));
  EXPECT_LT(curves.reconstruction.back(), 0.8 * curves.reconstruction.front());
  if (GetParam().variant.physics) {
    EXPECT_LT(curves.differential.back(), 0.5 * curves.differential.front());
  }
}

TEST_P(TwinVariantTraining, GeneratesWithWhatWasTrained) {
  const auto& [_, variant, engine] = GetParam();
  const fs::path path =
      train(checkpoint_at("g.ckpt"), quick_options(), "generate.h5", variant, engine);
  const artefact::Reader model(path, "model");
  const signal::WindowSet few = generate(model, variant, 2, Stream("g"), engine("cpu"));
  const signal::WindowSet many = generate(model, variant, 7, Stream("g"), engine("cpu"));
  ASSERT_EQ(few.size(), 4U);  // two fault classes
  ASSERT_EQ(many.size(), 14U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_GT(few.parameters[i].stiffness_n_per_m, 0);
    EXPECT_EQ(few.parameters[i].stiffness_n_per_m, many.parameters[i].stiffness_n_per_m);
    for (std::size_t t = 0; t < few.length; ++t) {
      EXPECT_NEAR(few.window(i)[t], many.window(i)[t], 1e-5);
    }
  }
}

const NamedVariant variants[] = {{"Full", full_model, native_engine},
                                 {"WithoutPhysics", without_physics, native_engine},
                                 {"FullByLibtorch", full_model, libtorch_engine},
                                 {"WithoutPhysicsByLibtorch", without_physics, libtorch_engine},
                                 {"Convolutional", convolutional_model, libtorch_engine},
                                 {"Recurrent", recurrent_model, libtorch_engine}};
INSTANTIATE_TEST_SUITE_P(Twin, TwinVariantTraining, testing::ValuesIn(variants),
                         [](const auto& info) { return info.param.name; });

TEST(TwinGeneration, RefusesAModelThatLacksWhatTheVariantHas) {
  for (const auto& [name, variant, engine] : variants) {
    if (variant.physics && variant.coder == CoderKind::dense) continue;
    const artefact::Reader model(
        train(checkpoint_at("v.ckpt"), quick_options(), "v.h5", variant, engine), "model");
    for (const MakeEngine other : {native_engine, libtorch_engine}) {
      EXPECT_THROW(generate(model, full_model, 1, Stream("g"), other("cpu")), artefact::Refusal)
          << name;
    }
  }
}

TEST(TwinTraining, WithoutPhysicsFollowsTheReconstructionLossAlone) {
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

  // Settings that it has no use for change nothing but what is stored of them, which is nothing.
  options.mass_kg = 3;
  options.clearance_um = 7;
  options.loss_weights = "fixed";
  Curves same;
  same.read(model_of("heavy.h5"));
  EXPECT_EQ(same.reconstruction, curves.reconstruction);
}

TEST(TwinTraining, HoldsFixedLossWeightsAtOne) {
  TwinOptions options = quick_options();
  options.loss_weights = "fixed";
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

/// Eq. 23 without its logarithms only ever rewards smaller weights.
TEST(TwinTraining, WithoutTheLogarithmsAllLossWeightsShrink) {
  TwinOptions options = quick_options();
  options.loss_weights = "adaptive-without-log";
  Curves curves;
  curves.read(artefact::Reader(train(checkpoint_at("n.ckpt"), options, "nolog.h5"), "model"));
  for (const auto weight : {&Curves::alpha, &Curves::beta, &Curves::gamma}) {
    EXPECT_LT((curves.*weight)[1], 1);
    EXPECT_LT((curves.*weight)[5], (curves.*weight)[1]);
    EXPECT_GT((curves.*weight)[5], 0);
  }
}

TEST(TwinTraining, DoesNotUseACheckpointOfOtherSettings) {
  nets::Checkpoint checkpoint = checkpoint_at("other.ckpt");
  checkpoint.interrupted = [] { return true; };
  EXPECT_THROW(train(checkpoint, quick_options(), "never.h5"), Error);
  checkpoint.interrupted = [] { return false; };
  checkpoint.provenance.options = "epochs = \"7\"\n";
  const std::string uncut =
      bytes_of(train(checkpoint_at("uncut.ckpt"), quick_options(), "uncut.h5"));
  EXPECT_EQ(bytes_of(train(checkpoint, quick_options(), "anew.h5")), uncut);
}

TEST(TwinTraining, StartsAnewFromADamagedCheckpoint) {
  nets::Checkpoint checkpoint = checkpoint_at("damaged.ckpt");
  std::ofstream(checkpoint.path) << "not a checkpoint";
  const std::string uncut =
      bytes_of(train(checkpoint_at("uncut.ckpt"), quick_options(), "uncut.h5"));
  EXPECT_EQ(bytes_of(train(checkpoint, quick_options(), "anew.h5")), uncut);
}

TEST(TwinTraining, StageOneLeavesTheLossWeightsAlone) {
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

TEST(TwinTraining, RefusesWindowsWithoutASecondDerivative) {
  const signal::WindowSet windows = known_windows(2);
  try {
    make_twin_training(windows, quick_options(), full_model, Stream("test"), native_engine("cpu"));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::usage);
    EXPECT_NE(std::string(error.what()).find("3 or more"), std::string::npos) << error.what();
  }
}

TEST(TwinTraining, RefusesASilentClass) {
  signal::WindowSet windows = known_windows();
  std::fill(windows.samples.begin(), windows.samples.begin() + std::ptrdiff_t{5} * 64, 1.0F);
  EXPECT_THROW(make_twin_training(windows, quick_options(), full_model, Stream("test"),
                                  native_engine("cpu")),
               Error);
}

TEST(TwinGeneration, DrawsFromTheTwinSpace) {
  const fs::path path = train(checkpoint_at("s.ckpt"), quick_options(), "space.h5");
  const artefact::Reader model(path, "model");
  const TwinSpace space(model);
  for (const auto& parameters :
       generate(model, full_model, 50, Stream("g"), native_engine("cpu")).parameters) {
    EXPECT_GE(parameters.stiffness_n_per_m, space.k_edges().front() * 1e8);
    EXPECT_LE(parameters.stiffness_n_per_m, space.k_edges().back() * 1e8);
    EXPECT_GE(parameters.damping_ns_per_m, space.c_edges().front() * 1e2);
    EXPECT_LE(parameters.damping_ns_per_m, space.c_edges().back() * 1e2);
  }
}

TEST(TwinGeneration, DependsOnTheModelThatIsKept) {
  TwinOptions options = quick_options();
  const fs::path best = train(checkpoint_at("k1.ckpt"), options, "best.h5");
  options.keep = "final";
  const fs::path last = train(checkpoint_at("k2.ckpt"), options, "final.h5");
  const artefact::Reader best_model(best, "model");
  const artefact::Reader final_model(last, "model");
  for (const std::string group : {"/best", "/final"}) {
    const std::string weight = group + "/net/decoder/0/weight";
    EXPECT_EQ(best_model.numbers<float>(weight, {0, 0}).values,
              final_model.numbers<float>(weight, {0, 0}).values);
  }
  const bool last_is_best = best_model.integer("/", "best_epoch") == options.epochs;
  const auto a = generate(best_model, full_model, 3, Stream("g"), native_engine("cpu")).samples;
  const auto b = generate(final_model, full_model, 3, Stream("g"), native_engine("cpu")).samples;
  EXPECT_EQ(a == b, last_is_best);
}

}  // namespace
}  // namespace piae::twin
