#include <gtest/gtest.h>

#include "artefact/reader.hpp"
#include "stages/tiny.hpp"

/// Methods that make faults from healthy windows only, from train to score.
namespace piae::stages {
namespace {

class WithoutKnown : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override { tiny_.run_chain_before("train"); }

  [[nodiscard]] Arguments training() const {
    return {"--method", GetParam(), "--known", "C.h5",     "--healthy",
            "B.h5",     "--seed",   "0",       "--output", "model.h5"};
  }

  const Tiny tiny_;
};

INSTANTIATE_TEST_SUITE_P(Stages, WithoutKnown,
                         testing::Values("piae-dt-zero", "healthy-plus-impulses"));

TEST_P(WithoutKnown, TrainsGeneratesVerifiesAndScores) {
  ASSERT_EQ(tiny_.run("train", training()).status, 0);
  const Arguments generating{"--model", "model.h5", "--count",  "3",
                             "--seed",  "0",        "--output", "E.h5"};
  ASSERT_EQ(tiny_.run("generate", generating).status, 0);
  EXPECT_EQ(tiny_.run("verify", {"model.h5", "E.h5"}).status, 0);
  ASSERT_EQ(
      tiny_.run("score", {"--generated", "E.h5", "--real", "D.h5", "--output", "score.h5"}).status,
      0);
  EXPECT_TRUE(artefact::Reader(tiny_ / "E.h5", "windows").has("/strikes/time_s"));
  const std::string few = bytes_of(tiny_ / "E.h5");
  ASSERT_EQ(tiny_.run("generate", generating).status, 0);
  EXPECT_EQ(bytes_of(tiny_ / "E.h5"), few);
}

TEST_P(WithoutKnown, DoesNotNeedKnownWindows) {
  ASSERT_EQ(tiny_.run("split", with(step_of("split").arguments, "--known-per-class", "0")).status,
            0);
  ASSERT_EQ(tiny_.run("train", training()).status, 0);
  ASSERT_EQ(tiny_
                .run("generate",
                     {"--model", "model.h5", "--count", "3", "--seed", "0", "--output", "E.h5"})
                .status,
            0);
  EXPECT_EQ(tiny_.run("verify", {"C.h5", "model.h5", "E.h5"}).status, 0);
}

TEST_P(WithoutKnown, NeedsHealthyWindows) {
  Arguments without = training();
  without.erase(without.begin() + 4, without.begin() + 6);
  expect_refusal(tiny_.run("train", without), "train", 2, {"--healthy"});
  EXPECT_FALSE(fs::exists(tiny_ / "model.h5"));
}

TEST_P(WithoutKnown, RefusesWindowsTooShortForAnImpact) {
  ASSERT_EQ(tiny_.run("split", with(step_of("split").arguments, "--window", "100")).status, 0);
  expect_refusal(tiny_.run("train", training()), "train", 65,
                 {"windows of 100 samples may miss them; use 112 samples or more"});
  EXPECT_FALSE(fs::exists(tiny_ / "model.h5"));
}

TEST_P(WithoutKnown, RefusesAReversedRange) {
  Arguments reversed = training();
  reversed.insert(reversed.end(), {"--level-from-db", "10", "--level-to-db", "0"});
  expect_refusal(tiny_.run("train", reversed), "train", 2, {"--level-from-db", "--level-to-db"});
}

}  // namespace
}  // namespace piae::stages
