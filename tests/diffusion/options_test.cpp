#include "diffusion/options.hpp"

#include <gtest/gtest.h>

#include "support/errors.hpp"

namespace piae::diffusion {
namespace {

TEST(DiffusionSettings, NeedDroppedClassesForGuidance) {
  DiffusionOptions options = ddpm_defaults;
  EXPECT_NO_THROW(require_possible(options));
  options.guidance = 2;
  EXPECT_NO_THROW(require_possible(options));
  options.dropped = 0;
  EXPECT_ERROR(require_possible(options), Exit::usage, "--guidance 2: needs windows whose class");
  options.guidance = 0;
  EXPECT_NO_THROW(require_possible(options));
}

}  // namespace
}  // namespace piae::diffusion
