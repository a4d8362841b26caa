#include "augment/physics.hpp"

#include <cmath>

#include "augment/methods.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"
#include "twin/space.hpp"

namespace piae::augment {
namespace {

constexpr std::size_t length = 1024;

struct Truth {
  signal::ClassInfo fault;
  double stiffness_n_per_m;
  double damping_ns_per_m;
};

signal::WindowSimulation simulation_of(const signal::ClassInfo& fault) {
  signal::WindowSimulation simulation;
  simulation.info.name = "example";
  simulation.info.sample_rate_hz = 12000;
  simulation.info.shaft_speed_rpm = 1797;
  simulation.info.classes = {{"Normal", signal::Defect::none, 0}, fault};
  simulation.length = length;
  simulation.rms = {1, 1};
  return simulation;
}

/// Makes windows at random angles, speeds and slips with the true (k, c), RMS 1, plus white noise.
signal::WindowSet windows_of(const Truth& truth, std::size_t count, double noise_rms) {
  signal::WindowSet windows = signal::simulate_windows(
      simulation_of(truth.fault), count, Stream("truth"), [&](std::size_t, Stream&) {
        return bearing::DynamicsOptions{.stiffness_n_per_m = truth.stiffness_n_per_m,
                                        .damping_ns_per_m = truth.damping_ns_per_m};
      });
  Stream noise("noise");
  for (float& x : windows.samples) x += static_cast<float>(noise_rms * noise.normal(0, 1));
  return windows;
}

class Recovery : public testing::TestWithParam<Truth> {
 protected:
  /// Expects stiffness within 5 % and damping within a factor of 1.5, for race defects. The damping
  /// of a faulty roller is harder to infer (augment/spectral_fit.hpp).
  static void expect_found(double noise_rms) {
    const Truth truth = GetParam();
    const FitOptions coarse{.stiffness_from_n_per_m = 7e7,
                            .damping_from_ns_per_m = 300,
                            .damping_to_ns_per_m = 3000,
                            .stiffness_grid = 14,
                            .damping_grid = 5};
    const SpectralFit fit(simulation_of(truth.fault), 1, coarse);
    const signal::WindowSet windows = windows_of(truth, 2, noise_rms);
    const auto both = fit.fit({windows.window(0), windows.window(1)});
    for (std::size_t i = 0; i < windows.size(); ++i) {
      const signal::DynamicParameters& found = both[i];
      EXPECT_NEAR(found.stiffness_n_per_m / truth.stiffness_n_per_m, 1, 0.05) << i;
      EXPECT_LT(std::abs(std::log(found.damping_ns_per_m / truth.damping_ns_per_m)), std::log(1.5))
          << i;
    }
  }
};

TEST_P(Recovery, SucceedsWithoutNoise) { expect_found(0); }
TEST_P(Recovery, SucceedsWithNoise10DbBelow) { expect_found(std::sqrt(0.1)); }

INSTANTIATE_TEST_SUITE_P(Truths, Recovery,
                         testing::Values(Truth{{"IR", signal::Defect::inner, 0.1778}, 1e8, 700},
                                         Truth{{"OR", signal::Defect::outer, 0.5334}, 2.5e8, 1000},
                                         Truth{{"IR", signal::Defect::inner, 0.5334}, 3.5e8, 1500}),
                         [](const auto& info) {
                           return info.param.fault.name + std::to_string(info.index);
                         });

/// Eq. 13 does not know a window's scale, and an offset is not a vibration.
TEST(SpectralFit, DoesNotDependOnScaleAndOffset) {
  const Truth truth{{"OR", signal::Defect::outer, 0.5334}, 2e8, 800};
  const SpectralFit fit(simulation_of(truth.fault), 1, {.stiffness_grid = 6, .damping_grid = 3});
  const signal::WindowSet windows = windows_of(truth, 1, 0);
  std::vector<float> other;
  for (const float x : windows.window(0)) other.push_back(1 + 8 * x);
  const signal::DynamicParameters a = fit.fit({windows.window(0)}).front();
  const signal::DynamicParameters b = fit.fit({other}).front();
  EXPECT_NEAR(a.stiffness_n_per_m / b.stiffness_n_per_m, 1, 1e-3);
  EXPECT_NEAR(a.damping_ns_per_m / b.damping_ns_per_m, 1, 1e-2);
}

TEST(SpectralFit, StaysBelowTheStiffnessThatLosesContact) {
  // Noise above the highest possible resonance: 1e8 N/m is the bound for 200 N and 2 um.
  signal::WindowSimulation simulation = simulation_of({"OR", signal::Defect::outer, 0.5334});
  simulation.options.dynamics.load_n = 200;
  const SpectralFit fit(simulation, 1, {.stiffness_grid = 4, .damping_grid = 3});
  std::vector<float> tone;
  for (std::size_t i = 0; i < length; ++i) {
    tone.push_back(static_cast<float>(std::sin(2.5 * static_cast<double>(i))));
  }
  EXPECT_LT(fit.fit({tone}).front().stiffness_n_per_m, 1e8);
}

TEST(SpectralFit, FitsEachOfManyWindowsAsAlone) {
  const Truth truth{{"OR", signal::Defect::outer, 0.5334}, 2e8, 800};
  const SpectralFit fit(simulation_of(truth.fault), 1, {.stiffness_grid = 6, .damping_grid = 3});
  const signal::WindowSet windows = windows_of(truth, bearing::courses_at_once + 2, 0.1);
  std::vector<SpectralFit::Window> all;
  for (std::size_t i = 0; i < windows.size(); ++i) all.push_back(windows.window(i));
  const auto together = fit.fit(all);
  ASSERT_EQ(together.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const signal::DynamicParameters alone = fit.fit({all[i]}).front();
    EXPECT_EQ(together[i].stiffness_n_per_m, alone.stiffness_n_per_m) << i;
    EXPECT_EQ(together[i].damping_ns_per_m, alone.damping_ns_per_m) << i;
  }
}

const std::string quick = "--stiffness-grid 3 --damping-grid 2 ";

std::filesystem::path model(const std::string& options, const nets::Checkpoint& checkpoint,
                            const std::string& name = "model.h5") {
  return train("physics", quick + options, known_windows(), checkpoint, name);
}

TEST(Physics, DrawsFromTheHistogramOfTheFittedParameters) {
  const auto path = model("", checkpoint_at("checkpoint"));
  const twin::TwinSpace space(artefact::Reader(path, "model"));
  EXPECT_EQ(space.points().size(), known_windows().size());
  for (const signal::DynamicParameters& p : generate("physics", path, 20).parameters) {
    EXPECT_GE(p.stiffness_n_per_m, space.k_edges().front() * 1e8);
    EXPECT_LE(p.stiffness_n_per_m, space.k_edges().back() * 1e8);
    EXPECT_GE(p.damping_ns_per_m, space.c_edges().front() * 1e2);
    EXPECT_LE(p.damping_ns_per_m, space.c_edges().back() * 1e2);
  }
}

TEST(Physics, ContinuedFitEqualsAnUninterruptedOne) {
  const std::string uncut = bytes_of(model("", checkpoint_at("uncut.checkpoint"), "uncut.h5"));
  for (int cut = 1; cut <= 2; ++cut) {
    nets::Checkpoint checkpoint = checkpoint_at("cut.checkpoint");
    int calls = 0;
    checkpoint.interrupted = [&] { return ++calls == cut; };
    EXPECT_THROW(model("", checkpoint), Error) << "cut after " << cut;
    checkpoint.interrupted = [] { return false; };
    EXPECT_EQ(bytes_of(model("", checkpoint, "continued.h5")), uncut) << "cut after " << cut;
  }
}

TEST(Physics, RefusesEmptyBounds) {
  const auto refused = [](const std::string& options) {
    return model(options, checkpoint_at("checkpoint"));
  };
  EXPECT_ERROR(refused("--stiffness-from-n-per-m 5e8"), Exit::usage, "--stiffness-from-n-per-m");
  EXPECT_ERROR(refused("--load-n 30"), Exit::usage, "--stiffness-from-n-per-m");
  EXPECT_ERROR(refused("--damping-from-ns-per-m 6000"), Exit::usage,
               "--damping-from-ns-per-m 6000");
}

}  // namespace
}  // namespace piae::augment
