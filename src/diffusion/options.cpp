#include "diffusion/options.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>

#include "base/error.hpp"
#include "diffusion/ranges.hpp"

namespace piae::diffusion {

namespace {

cli::Check channels() {
  return cli::number("16, 32, 48, ...", "a multiple of 16, at most 1024",
                     [](double x) { return x >= 16 && x <= 1024 && std::fmod(x, 16) == 0; });
}

}  // namespace

void bind(const cli::Options& command, DiffusionOptions& o) {
  command.add("--epochs", o.course.epochs, "passes over the known windows")
      .check(cli::positive_number());
  command.add("--batch", o.course.batch, "windows in a batch").check(cli::positive_number());
  command.add("--learning-rate", o.course.learning_rate, "learning rate of Adam at the start")
      .check(cli::positive_number());
  command.add("--channels", o.size.channels, "channels of a block").check(channels());
  command.add("--blocks", o.size.blocks, "residual blocks of two convolutions")
      .check(cli::whole_number(1, 32));
  command.add("--dropped", o.dropped, "share of windows whose class is not told, for guidance")
      .check(cli::within({.low = 0, .high = 0.9}));
  command.add("--guidance", o.guidance, "weight of classifier-free guidance; 0: none")
      .check(cli::within(ranges::guidance));
  command.add("--steps", o.steps, "steps from noise to a window")
      .check(cli::whole_number(static_cast<std::int64_t>(ranges::steps.low),
                               static_cast<std::int64_t>(ranges::steps.high)));
}

void require_possible(const DiffusionOptions& o) {
  if (o.guidance == 0 || o.dropped > 0) return;
  throw Error(
      Exit::usage,
      fmt::format("--guidance {}: needs windows whose class is not told; add --dropped 0.1, "
                  "or leave --guidance out",
                  o.guidance));
}

void bind(const cli::Options& command, HealthyOptions& o) {
  command.add("--healthy-epochs", o.course.epochs, "passes over the healthy windows")
      .check(cli::positive_number());
  command.add("--healthy-batch", o.course.batch, "healthy windows in a batch")
      .check(cli::positive_number());
  command
      .add("--healthy-learning-rate", o.course.learning_rate,
           "learning rate of Adam at the start, on healthy windows")
      .check(cli::positive_number());
  command.add("--change-channels", o.change.channels, "channels of the network of changes")
      .check(channels());
  command.add("--change-blocks", o.change.blocks, "residual blocks of the network of changes")
      .check(cli::whole_number(1, 32));
}

}  // namespace piae::diffusion
