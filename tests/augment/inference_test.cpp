#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "augment/methods.hpp"
#include "base/error.hpp"
#include "support/simulated_windows.hpp"
#include "twin/physics.hpp"
#include "twin/space.hpp"

namespace piae::augment {
namespace {

/// Tests for every method that infers stiffness and damping.
class Inferring : public testing::TestWithParam<std::string> {
 protected:
  static std::string options() {
    return GetParam() == "piae-dt-phase"
               ? "--epochs 2 --width 8 --simulations 4 --inference-epochs 2 --inference-width 8"
               : "--epochs 2 --width 8";
  }
  const signal::WindowSet known_ = simulated_windows(2, "known");
  const std::filesystem::path model_ =
      train(GetParam(), options(), known_, checkpoint_at("checkpoint"), "model.h5");
  const artefact::Reader reader_{model_, "model"};
};

// The training itself computed the twin space in the model from the windows C.
TEST_P(Inferring, InfersThePointsOfTheTwinSpaceFromKnownWindows) {
  const auto inferred = make_method(GetParam())->infer(reader_, known_, {});
  const std::vector<twin::TwinPoint> points = twin::TwinSpace(reader_).points();
  ASSERT_EQ(inferred.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double k = points[i].k * twin::stiffness_scale_n_per_m;
    const double c = points[i].c * twin::damping_scale_ns_per_m;
    EXPECT_NEAR(inferred[i].stiffness_n_per_m, k, 1e-5 * k) << i;
    EXPECT_NEAR(inferred[i].damping_ns_per_m, c, 1e-5 * c) << i;
  }
}

TEST_P(Inferring, RefusesWindowsOfOtherClasses) {
  signal::WindowSet other = known_;
  other.info.classes.push_back({"another", signal::Defect::inner, 1});
  EXPECT_THROW((void)make_method(GetParam())->infer(reader_, other, {}), Error);
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::ranges::replace(name, '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Methods, Inferring,
                         testing::Values("piae-dt", "ae", "piae-dt-cnn", "piae-dt-rnn",
                                         "piae-dt-tcn", "piae-dt-transformer", "piae-dt-phase"),
                         test_name);

TEST(Inferring, NeedsAnEncoder) {
  const signal::WindowSet known = simulated_windows(2, "known");
  artefact::Writer writer("model");
  writer.attribute("/", "method", std::string("smote"));
  writer.save(scratch_file("model.h5"), {});
  const artefact::Reader reader(scratch_file("model.h5"), "model");
  EXPECT_THAT([&] { (void)make_method("smote")->infer(reader, known, {}); },
              testing::ThrowsMessage<Error>(testing::HasSubstr("infers neither")));
}

}  // namespace
}  // namespace piae::augment
