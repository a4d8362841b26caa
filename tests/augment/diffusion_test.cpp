#include "augment/diffusion.hpp"

#include "augment/methods.hpp"
#include "support/errors.hpp"
#include "support/impact_windows.hpp"

namespace piae::augment {
namespace {

signal::WindowSet faults(std::size_t length) {
  signal::WindowSet set = no_impact_windows(length);
  Stream stream("faults");
  for (const Label label : {1, 2}) add_impact_windows(set, label, 2, stream);
  return set;
}

std::vector<float> generated_by(const std::string& method) {
  const auto model = train(method, "--epochs 2 --channels 16 --blocks 1 --steps 2 ", faults(512),
                           checkpoint_at(method + ".checkpoint"), method + ".h5");
  return generate(method, model, 2).samples;
}

// Their noise is the same, so only what they learned from differs.
TEST(Diffusion, WithDrawnAnglesLearnsFromOtherWindows) {
  for (const std::string method : {"ddpm", "ddpm-healthy", "flow"}) {
    EXPECT_EQ(generated_by(method), generated_by(method));
    EXPECT_NE(generated_by(method), generated_by(method + "-angle"));
  }
}

TEST(Diffusion, WithDrawnAnglesNeedsAWholeFaultCycle) {
  EXPECT_ERROR(train("ddpm-angle", "--epochs 1 --channels 16 --blocks 1", faults(64),
                     checkpoint_at("short.checkpoint"), "short.h5"),
               Exit::bad_input, "windows of 64 samples are too short for one impact of class IR");
}

}  // namespace
}  // namespace piae::augment
