// Methods that make faults without known fault windows.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "augment/methods.hpp"
#include "support/errors.hpp"

namespace piae::augment {
namespace {

const std::vector<std::string> methods{"piae-dt-zero", "healthy-plus-impulses"};

/// Returns C without windows, only with the split's description of the machine.
signal::WindowSet no_known_window() {
  signal::WindowSet none = known_windows();
  none.samples.clear();
  none.labels.clear();
  return none;
}

std::filesystem::path model_of(const std::string& name, const signal::WindowSet& known,
                               const signal::WindowSet& healthy) {
  artefact::Writer writer("model");
  writer.attribute("/", "method", name);
  const std::unique_ptr<Method> method = make_method(name);
  method->use_healthy(healthy);
  method->train(known, Stream("train"), {}, checkpoint_at("checkpoint"), writer);
  std::filesystem::path path = scratch_file(name + ".h5");
  writer.save(path, {});
  return path;
}

TEST(WithoutKnown, AreMarkedInTheCatalogue) {
  for (const CatalogueEntry& entry : catalogue()) {
    EXPECT_EQ(entry.without_known, std::ranges::find(methods, entry.name) != methods.end());
    if (entry.without_known) {
      EXPECT_EQ(entry.healthy, Healthy::required);
    }
  }
}

TEST(WithoutKnown, MakesEveryFaultClassFromHealthyWindowsAlone) {
  for (const std::string& name : methods) {
    const signal::WindowSet healthy = as_healthy(known_windows());
    const signal::WindowSet made = generate(name, model_of(name, no_known_window(), healthy), 4);
    EXPECT_EQ(made.labels, (std::vector<std::int32_t>{1, 1, 1, 1, 2, 2, 2, 2}));
    EXPECT_EQ(made.impact_times_s.size(), 8U);
    EXPECT_EQ(made.parameters.size(), name == "piae-dt-zero" ? 8U : 0U);
  }
}

TEST(WithoutKnown, DoesNotDependOnKnownWindows) {
  for (const std::string& name : methods) {
    const signal::WindowSet healthy = as_healthy(known_windows());
    const auto without = generate(name, model_of(name, no_known_window(), healthy), 3).samples;
    EXPECT_EQ(generate(name, model_of(name, known_windows(), healthy), 3).samples, without);
  }
}

TEST(WithoutKnown, NamesWhatIsMissing) {
  for (const std::string& name : methods) {
    artefact::Writer writer("model");
    EXPECT_ERROR(make_method(name)->train(known_windows(), Stream("train"), {},
                                          checkpoint_at("checkpoint"), writer),
                 Exit::usage, "give --healthy B.h5");
    EXPECT_ERROR(model_of(name, known_windows(), as_healthy(known_windows(128))), Exit::bad_input,
                 "healthy windows have 128 samples, but known windows have 64");
    signal::WindowSet unknown = as_healthy(known_windows());
    unknown.info.shaft_speed_rpm = 0;
    EXPECT_ERROR(model_of(name, no_known_window(), unknown), Exit::bad_input,
                 "a shaft speed of 0 rpm");
    signal::WindowSet nothing = as_healthy(no_known_window());
    EXPECT_ERROR(model_of(name, no_known_window(), nothing), Exit::bad_input, "no healthy window");
  }
}

}  // namespace
}  // namespace piae::augment
