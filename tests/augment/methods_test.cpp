// Requirements of the grid for every method that generates from known windows.

#include "augment/methods.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <set>

#include "augment/catalogue.hpp"
#include "base/error.hpp"

namespace piae::augment {
namespace {

struct Case {
  std::string method;
  std::string options;        ///< for a quick training
  std::size_t samples = 128;  ///< in a window, which must hold a cycle of each fault
};

void PrintTo(const Case& each, std::ostream* out) { *out << each.method; }

const std::string small_diffusion =
    "--epochs 4 --batch 4 --channels 16 --blocks 1 --steps 3 --guidance 0.5";

const std::string small_twin = "--epochs 4 --width 8";

std::string name_of(const testing::TestParamInfo<Case>& info) {
  std::string name = info.param.method;
  std::ranges::replace(name, '-', '_');
  return name;
}

std::filesystem::path trained(const Case& method, const std::string& name,
                              const nets::Checkpoint& checkpoint) {
  return train(method.method, method.options, known_windows(method.samples), checkpoint, name);
}

class GeneratingMethod : public testing::TestWithParam<Case> {
 protected:
  [[nodiscard]] static std::filesystem::path model(const std::string& name) {
    return trained(GetParam(), name, checkpoint_at(name + ".checkpoint"));
  }
};

const std::vector<Case> generating{
    {"dynamics", ""},
    {"physics", "--stiffness-grid 3 --damping-grid 2"},
    {"smote", "--neighbours 2"},
    {"oversample", ""},
    {"shift", ""},
    {"mixup", ""},
    {"aligned-mixup", ""},
    {"spectral", "--equaliser-db 3"},
    {"adasyn", "--neighbours 2"},
    {"borderline-smote", "--neighbours 2"},
    {"resample", ""},
    {"randomise", ""},
    {"strike-twin", "--equaliser-db 3 --background 0.2"},
    {"piae-dt-zero", "--resonances 3"},
    {"healthy-plus-impulses", ""},
    {"vae", "--epochs 4 --width 8 --latent 3 --batch 4"},
    // Three batches per epoch: the generator's steps fall on other batches in each.
    {"wgan-gp", "--epochs 4 --width 8 --latent 3 --batch 4 --critic-steps 2"},
    {"ddpm", small_diffusion},
    {"ddpm-healthy", small_diffusion + " --healthy-epochs 2 --change-blocks 1"},
    {"flow", small_diffusion},
    {"ddpm-angle", small_diffusion},
    {"ddpm-healthy-angle", small_diffusion + " --healthy-epochs 2 --change-blocks 1"},
    {"flow-angle", small_diffusion},
    {"piae-dt", small_twin},
    {"ae", small_twin},
    {"piae-dt-cnn", small_twin},
    {"piae-dt-rnn", small_twin},
    {"piae-dt-tcn", small_twin},
    {"piae-dt-transformer", small_twin},
    {"piae-dt-phase", small_twin + " --simulations 20 --inference-epochs 1", 260},
};
INSTANTIATE_TEST_SUITE_P(Augment, GeneratingMethod, testing::ValuesIn(generating), name_of);

// All but the baseline, which generates nothing, and the ceiling, which needs D.
TEST(GeneratingMethods, AreAllTestedHere) {
  std::set<std::string> tested;
  for (const Case& each : generating) tested.insert(each.method);
  std::set<std::string> all;
  for (const CatalogueEntry& entry : catalogue()) {
    if (entry.make != nullptr && entry.kind != Kind::ceiling) all.insert(entry.name);
  }
  EXPECT_EQ(tested, all);
}

TEST_P(GeneratingMethod, MakesWindowsOfEveryFaultClassInOrder) {
  const signal::WindowSet windows = generate(GetParam().method, model("model.h5"), 3);
  EXPECT_EQ(windows.labels, (std::vector<std::int32_t>{1, 1, 1, 2, 2, 2}));
  EXPECT_EQ(windows.length, GetParam().samples);
  EXPECT_EQ(windows.samples.size(), 6U * GetParam().samples);
  EXPECT_EQ(windows.info.classes[2].name, "OR");
  EXPECT_TRUE(windows.record.empty());  // not cut from any recording
}

TEST_P(GeneratingMethod, HasParentsOfTheSameClassOrNone) {
  const std::set<std::string> with{"smote",         "oversample", "shift",      "mixup",
                                   "aligned-mixup", "spectral",   "adasyn",     "borderline-smote",
                                   "resample",      "randomise",  "strike-twin"};
  const signal::WindowSet windows = generate(GetParam().method, model("model.h5"), 12);
  const bool records_parents = with.contains(GetParam().method);
  ASSERT_EQ(windows.parents.size(), records_parents ? windows.size() : 0);
  const signal::WindowSet known = known_windows(GetParam().samples);
  for (std::size_t i = 0; i < windows.parents.size(); ++i) {
    EXPECT_FALSE(windows.parents[i].empty()) << i;
    for (const std::int32_t parent : windows.parents[i]) {
      EXPECT_EQ(known.labels.at(static_cast<std::size_t>(parent)), windows.labels[i]) << i;
    }
  }
}

TEST_P(GeneratingMethod, FirstWindowsDoNotDependOnTheCount) {
  const std::filesystem::path path = model("model.h5");
  const signal::WindowSet few = generate(GetParam().method, path, 2);
  const signal::WindowSet many = generate(GetParam().method, path, 7);
  for (std::size_t label = 0; label < 2; ++label) {
    for (std::size_t i = 0; i < 2; ++i) {
      const auto expected = few.window(label * 2 + i);
      const auto window = many.window(label * 7 + i);
      EXPECT_TRUE(std::ranges::equal(window, expected)) << "class " << label << ", window " << i;
    }
  }
}

TEST_P(GeneratingMethod, MakesWindowsThatDifferFromEachOther) {
  const signal::WindowSet windows = generate(GetParam().method, model("model.h5"), 20);
  for (std::size_t i = 0; i + 1 < windows.size(); ++i) {
    EXPECT_FALSE(std::ranges::equal(windows.window(i), windows.window(i + 1))) << i;
  }
}

TEST_P(GeneratingMethod, GivesTheSameModelTwice) {
  EXPECT_EQ(bytes_of(model("first.h5")), bytes_of(model("second.h5")));
}

/// Methods whose windows do not depend on true forces. Those of the twins do: the clearance and the
/// defect have a size.
class MethodWithoutForces : public testing::TestWithParam<Case> {};

std::vector<Case> without_forces() {
  std::vector<Case> cases = generating;
  std::erase_if(cases, [](const Case& each) { return find_entry(each.method)->infers; });
  return cases;
}
INSTANTIATE_TEST_SUITE_P(Augment, MethodWithoutForces, testing::ValuesIn(without_forces()),
                         name_of);

TEST_P(MethodWithoutForces, KeepsTheUnitOfTheRecordings) {
  signal::WindowSet known = known_windows(GetParam().samples);
  const auto small = train(GetParam().method, GetParam().options, known,
                           checkpoint_at("small.checkpoint"), "small.h5");
  for (float& sample : known.samples) sample *= 1024;  // exact in binary
  const auto large = train(GetParam().method, GetParam().options, known,
                           checkpoint_at("large.checkpoint"), "large.h5");
  const std::vector<float> in_small_unit = generate(GetParam().method, small, 2).samples;
  const std::vector<float> in_large_unit = generate(GetParam().method, large, 2).samples;
  for (std::size_t i = 0; i < in_small_unit.size(); ++i) {
    ASSERT_NEAR(in_large_unit[i], in_small_unit[i] * 1024, 1e-3 * (1 + std::abs(in_large_unit[i])));
  }
}

/// Methods trained in epochs.
class TrainedMethod : public testing::TestWithParam<Case> {};
std::vector<Case> trained_in_epochs() {
  const std::set<std::string> names{"vae", "wgan-gp", "ddpm", "ddpm-healthy", "flow"};
  std::vector<Case> cases = generating;
  std::erase_if(cases, [&](const Case& each) { return !names.contains(each.method); });
  return cases;
}
INSTANTIATE_TEST_SUITE_P(Augment, TrainedMethod, testing::ValuesIn(trained_in_epochs()), name_of);

TEST_P(TrainedMethod, ContinuedTrainingEqualsAnUninterruptedOne) {
  const std::string uncut = bytes_of(trained(GetParam(), "uncut.h5", checkpoint_at("uncut")));
  for (int cut = 1; cut <= 4; ++cut) {
    nets::Checkpoint checkpoint = checkpoint_at("cut");
    int calls = 0;
    checkpoint.interrupted = [&] { return ++calls == cut; };
    EXPECT_THROW(trained(GetParam(), "never.h5", checkpoint), Error) << "cut after " << cut;
    checkpoint.interrupted = [] { return false; };
    EXPECT_EQ(bytes_of(trained(GetParam(), "continued.h5", checkpoint)), uncut)
        << "cut after " << cut;
  }
}

TEST_P(TrainedMethod, ReportsDivergence) {
  try {
    train(GetParam().method, GetParam().options + " --learning-rate 1e30",
          known_windows(GetParam().samples), checkpoint_at("checkpoint"), "never.h5");
    FAIL() << "did not diverge";
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::failed);
    EXPECT_NE(std::string(error.what()).find("--learning-rate"), std::string::npos);
  }
}

TEST_P(TrainedMethod, RefusesAConstantClass) {
  signal::WindowSet known = known_windows(GetParam().samples);
  std::fill_n(known.samples.begin(), 5 * known.length, 1.0F);
  EXPECT_THROW(train(GetParam().method, "", known, checkpoint_at("checkpoint"), "never.h5"), Error);
}

}  // namespace
}  // namespace piae::augment
