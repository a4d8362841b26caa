#include <gtest/gtest.h>

#include "scoring/diagnosis_record.hpp"
#include "stages/tiny.hpp"

namespace piae::stages {
namespace {

using artefact::Reader;

TEST(Backend, LibtorchGivesTheSameDiagnosisButForRounding) {
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
  EXPECT_NE(libtorch_file.digest(), native_file.digest());  // it was indeed computed by another
}

TEST(Backend, ThatCannotBeIsNamedWithThoseThatCan) {
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
