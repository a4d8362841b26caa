#include <gtest/gtest.h>

#include "artefact/reader.hpp"
#include "stages/tiny.hpp"

/// Healthy windows B, from which strike-twin learns the machine's background, and among which the
/// variants of SMOTE look for neighbours.
namespace piae::stages {
namespace {

const Arguments train_on_healthy{"--method", "strike-twin", "--known", "C.h5",     "--healthy",
                                 "B.h5",     "--seed",      "0",       "--output", "model.h5"};

class Healthy : public testing::Test {
 protected:
  void SetUp() override { tiny_.run_chain_before("train"); }

  [[nodiscard]] Outcome generate() const {
    return tiny_.run("generate",
                     {"--model", "model.h5", "--count", "2", "--seed", "0", "--output", "E.h5"});
  }

  const Tiny tiny_;
};

TEST_F(Healthy, WindowsAreStoredAsASpectrumAndAnInput) {
  ASSERT_EQ(tiny_.run("train", train_on_healthy).status, 0);
  const artefact::Reader model(tiny_ / "model.h5", "model");
  EXPECT_TRUE(model.has("/healthy/log_amplitude"));
  ASSERT_EQ(generate().status, 0);
  EXPECT_EQ(tiny_.run("verify", {"model.h5", "E.h5"}).status, 0);
  EXPECT_TRUE(artefact::Reader(tiny_ / "E.h5", "windows").has("/strikes/time_s"));
}

TEST_F(Healthy, WindowsMustBeBOfTheSameSplit) {
  expect_refusal(tiny_.run("train", with(train_on_healthy, "--healthy", "D.h5")), "train", 65,
                 {"D.h5", "role D", "must have role B"});
  fs::create_directory(tiny_ / "other");
  ASSERT_EQ(tiny_
                .run("split",
                     with(with(step_of("split").arguments, "--seed", "1"), "--output-dir", "other"))
                .status,
            0);
  expect_refusal(tiny_.run("train", with(train_on_healthy, "--healthy", "other/B.h5")), "train", 65,
                 {"other/B.h5", "not belong to one split"});
  EXPECT_FALSE(fs::exists(tiny_ / "model.h5"));
}

TEST_F(Healthy, WindowsAreRequiredForAHealthyBackground) {
  Arguments without = train_on_healthy;
  without.erase(without.begin() + 4, without.begin() + 6);
  without.insert(without.end(), {"--background-from", "healthy"});
  expect_refusal(tiny_.run("train", without), "train", 2, {"--healthy B.h5"});
  EXPECT_FALSE(fs::exists(tiny_ / "model.h5"));
}

TEST_F(Healthy, WindowsAreRequiredByVariantsOfSmote) {
  for (const std::string method : {"adasyn", "borderline-smote"}) {
    Arguments without{"--method", method, "--known", "C.h5", "--seed", "0", "--output", "model.h5"};
    expect_refusal(tiny_.run("train", without), "train", 2, {"--healthy"});
    EXPECT_FALSE(fs::exists(tiny_ / "model.h5"));
    without.insert(without.end(), {"--healthy", "B.h5"});
    const Outcome trained = tiny_.run("train", without);
    ASSERT_EQ(trained.status, 0) << trained.err;
    const std::int64_t as_smote =
        artefact::Reader(tiny_ / "model.h5", "model").integer("/", "classes_as_smote");
    const std::string remark = '(' + std::to_string(as_smote) + " of them as smote: no ";
    EXPECT_EQ(trained.out.find(remark) != std::string::npos, as_smote > 0) << trained.out;
    ASSERT_EQ(generate().status, 0);
    EXPECT_EQ(tiny_.run("verify", {"model.h5", "E.h5"}).status, 0);
    fs::remove(tiny_ / "model.h5");
  }
}

TEST_F(Healthy, WindowsAreRefusedByOtherMethods) {
  expect_refusal(tiny_.run("train", with(train_on_healthy, "--method", "smote")), "train", 2,
                 {"--healthy"});
}

TEST_F(Healthy, ReversedLoadZoneIsRefused) {
  Arguments reversed = train_on_healthy;
  reversed.insert(reversed.end(), {"--load-zone-from", "0.8", "--load-zone-to", "0.4"});
  expect_refusal(tiny_.run("train", reversed), "train", 2, {"--load-zone-from", "--load-zone-to"});
  EXPECT_FALSE(fs::exists(tiny_ / "model.h5"));
}

}  // namespace
}  // namespace piae::stages
