#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "scoring/diagnosis_record.hpp"
#include "signal/window_set.hpp"
#include "stages/tiny.hpp"

namespace piae::stages {
namespace {

using artefact::Reader;
using testing::HasSubstr;
using testing::Not;

TEST(Backend, LibtorchGivesTheSameDiagnosisExceptForRounding) {
  SKIP_WITHOUT_LIBTORCH();
  const Tiny tiny;
  tiny.run_chain_before("tabulate");
  const Step step = step_of("diagnose");
  const auto arguments = with(step.arguments, "--output", "libtorch.h5");
  const Outcome outcome = tiny.run("diagnose", with(arguments, "--backend", "libtorch"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("diagnosed ")) << outcome.out;

  const Reader native_file(tiny / step.outputs.front(), "diagnosis");
  const Reader libtorch_file(tiny / "libtorch.h5", "diagnosis");
  const auto native = scoring::read_diagnosis(native_file);
  const auto libtorch = scoring::read_diagnosis(libtorch_file);
  EXPECT_EQ(libtorch.method, native.method);
  ASSERT_EQ(libtorch.scores.size(), native.scores.size());
  for (std::size_t i = 0; i < native.scores.size(); ++i) {
    EXPECT_NEAR(libtorch.scores[i], native.scores[i], 0.05);
  }
  ASSERT_EQ(libtorch.loss.size(), 2U);
  EXPECT_NEAR(libtorch.loss[0], native.loss[0], 1e-2 * native.loss[0]);
  EXPECT_NE(libtorch_file.digest(), native_file.digest());  // by another back end
}

/// Returns the libraries that the dynamic linker would load for a program.
std::string libraries_of(const Tiny& tiny, const std::string& program) {
  return stages::run(tiny.path(), program, {}, {{{"LD_TRACE_LOADED_OBJECTS", "1"}}}).out;
}

TEST(Backend, NoProgramOfADefaultRunLoadsLibtorch) {
  const Tiny tiny;
  for (const auto& entry : fs::directory_iterator(fs::path(PIAE_SOURCE) / "stages")) {
    const std::string stage = entry.path().stem();
    EXPECT_THAT(libraries_of(tiny, stage), HasSubstr("libhdf5")) << stage;
    EXPECT_THAT(libraries_of(tiny, stage), Not(HasSubstr("libtorch"))) << stage;
  }
}

TEST(Backend, ProgramsNamedAfterLibtorchLoadIt) {
  SKIP_WITHOUT_LIBTORCH();
  const Tiny tiny;
  for (const std::string stage : {"train", "generate", "diagnose"}) {
    EXPECT_THAT(libraries_of(tiny, stage + "-libtorch"), HasSubstr("libtorch")) << stage;
  }
}

/// Returns the arguments of a training of one epoch.
Arguments training(const std::string& method, const std::string& model) {
  Arguments arguments{"--method", method,   "--epochs", "1",        "--known",
                      "C.h5",     "--seed", "0",        "--output", model};
  const bool is_diffusion = method.starts_with("ddpm") || method == "flow";
  for (const char* const word :
       is_diffusion ? std::array{"--channels", "16"} : std::array{"--width", "8"}) {
    arguments.emplace_back(word);
  }
  if (method == "ddpm-healthy") {
    for (const char* const word : {"--healthy", "B.h5", "--healthy-epochs", "1"}) {
      arguments.emplace_back(word);
    }
  }
  return arguments;
}

const std::vector<std::string> methods_with_networks{
    "vae",         "wgan-gp",      "piae-dt",     "ae",
    "piae-dt-cnn", "piae-dt-rnn",  "piae-dt-tcn", "piae-dt-transformer",
    "ddpm",        "ddpm-healthy", "flow"};

TEST(Backend, IsLibtorchOnlyIfRequested) {
  const Tiny tiny;
  tiny.run_chain_before("train");
  const fs::path alone = tiny / "bin/train";  // without train-libtorch next to it
  fs::create_directories(alone.parent_path());
  fs::copy_file(fs::path(PIAE_BIN) / "train", alone);
  const std::string program = fs::relative(alone, PIAE_BIN);
  for (const std::string& method : methods_with_networks) {
    const Outcome outcome = tiny.run(program, training(method, "model.h5"));
    EXPECT_EQ(outcome.status, 0) << method << outcome.err;
  }
  expect_refusal(tiny.run(program, with(training("vae", "l.h5"), "--backend", "libtorch")), "train",
                 1, {"needs LibTorch", "bin/train-libtorch", "make build LIBTORCH=on"});
}

// Checks that both back ends generate the same windows from a model, except for rounding.
TEST(Backend, ModelsAreReadByBothBackEnds) {
  SKIP_WITHOUT_LIBTORCH();
  const Tiny tiny;
  tiny.run_chain_before("train");
  for (const std::string& method : methods_with_networks) {
    const Outcome trained =
        tiny.run("train", with(training(method, "model.h5"), "--backend", "libtorch"));
    ASSERT_EQ(trained.status, 0) << trained.err;
    std::vector<std::vector<float>> generated;
    for (const std::string backend : {"native", "libtorch"}) {
      const std::string file = backend + ".h5";
      const Outcome outcome = tiny.run("generate", {"--model", "model.h5", "--count", "3", "--seed",
                                                    "0", "--backend", backend, "--output", file});
      ASSERT_EQ(outcome.status, 0) << outcome.err;
      generated.push_back(signal::read_window_set(Reader(tiny / file, "windows")).samples);
    }
    ASSERT_EQ(generated[0].size(), generated[1].size());
    for (std::size_t i = 0; i < generated[0].size(); ++i) {
      ASSERT_NEAR(generated[0][i], generated[1][i], 1e-4) << method << " " << i;
    }
  }
}

TEST(Backend, StopsWithACheckpointWhileLibTorchStarts) {
  SKIP_WITHOUT_LIBTORCH();
  const Tiny tiny;
  tiny.run_chain_before("train");
  const Arguments arguments = with(step_of("train").arguments, "--epochs", "120");
  expect_checkpoints_at_once(tiny, with(arguments, "--backend", "libtorch"));
}

TEST(Backend, ImpossibleBackendIsNamedWithPossibleOnes) {
  const Tiny tiny;
  tiny.run_chain_before("train");
  const Arguments& arguments = chain()[5].arguments;
  expect_refusal(tiny.run("diagnose", with(arguments, "--backend", "eigen")), "diagnose", 2,
                 {"--backend", "eigen", "auto", "native", "libtorch"});
  expect_refusal(
      tiny.run("diagnose", with(with(arguments, "--backend", "native"), "--device", "cuda")),
      "diagnose", 2, {"--backend", "native", "cuda", "libtorch"});
  expect_refusal(tiny.run("diagnose", with(arguments, "--device", "tpu")), "diagnose", 2,
                 {"--device", "tpu", "cpu", "cuda"});
}

}  // namespace
}  // namespace piae::stages
