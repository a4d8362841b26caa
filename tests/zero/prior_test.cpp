#include "zero/prior.hpp"

#include <gtest/gtest.h>

#include "support/checkpoints.hpp"
#include "support/command_line.hpp"
#include "support/errors.hpp"
#include "zero/impulses.hpp"

namespace piae::zero {
namespace {

Prior prior_of(const std::string& line) {
  Prior prior;
  cli::parse(line, [&](const cli::Options& command) { bind(command, prior); });
  return prior;
}

artefact::Reader stored(artefact::Writer& writer) {
  writer.save(scratch_file("prior.h5"), {});
  return {scratch_file("prior.h5"), "model"};
}

TEST(PriorOptions, ComeFromTheCommandLine) {
  const Prior prior = prior_of(
      "--slip 0 --ball-random 0.25 --ball-track 1 --both-races 1 --load-zone off --edges off "
      "--resonances 1 --healthy-structure 0 --level-from-db -5 --size-to-mm 2 --stray-knocks 0");
  EXPECT_EQ(prior.slip, 0);
  EXPECT_EQ(prior.random_strikes, 0.25);
  EXPECT_EQ(prior.least_on_track, 1);
  EXPECT_EQ(prior.other_race, 1);
  EXPECT_EQ(prior.load_zone, Switch::off);
  EXPECT_EQ(prior.edges, Switch::off);
  EXPECT_EQ(prior.resonances, 1);
  EXPECT_EQ(prior.healthy_structure, 0);
  EXPECT_EQ(prior.least_level_db, -5);
  EXPECT_EQ(prior.largest_size_mm, 2);
  EXPECT_EQ(prior.stray_knocks, 0);
  EXPECT_THROW(prior_of("--slip 0.5"), cli::Refused);
  EXPECT_THROW(prior_of("--damping-ratio-from 0"), cli::Refused);
  EXPECT_THROW(prior_of("--resonances 0"), cli::Refused);
  EXPECT_THROW(prior_of("--edges maybe"), cli::Refused);
}

TEST(PriorOptions, AreStoredAndRead) {
  artefact::Writer writer("model");
  write(writer, prior_of("--jitter 0.001 --roughness 0.125 --load-zone off --resonances 3"));
  const Prior read = read_prior(stored(writer));
  EXPECT_EQ(read.jitter, 0.001);
  EXPECT_EQ(read.roughness, 0.125);
  EXPECT_EQ(read.load_zone, Switch::off);
  EXPECT_EQ(read.edges, Switch::on);
  EXPECT_EQ(read.resonances, 3);
  EXPECT_EQ(read.largest_level_db, Prior{}.largest_level_db);
}

TEST(PriorOptions, HaveNoRangeThatEndsBeforeItBegins) {
  Prior prior = prior_of("--size-from-mm 3 --size-to-mm 2");
  EXPECT_ERROR(require_order(prior), Exit::usage, "--size-from-mm is above --size-to-mm");
  EXPECT_NO_THROW(require_order(prior_of("--size-from-mm 2 --size-to-mm 2")));
  artefact::Writer writer("model");
  write(writer, prior);
  EXPECT_ERROR(read_prior(stored(writer)), Exit::bad_input, "size_from_mm is above size_to_mm");
}

TEST(ImpulseOptions, AreBoundStoredAndRead) {
  ImpulseOptions options;
  cli::parse("--modulation 0.5 --level-to-db 3",
             [&](const cli::Options& command) { bind(command, options); });
  artefact::Writer writer("model");
  write(writer, options);
  const ImpulseOptions read = read_impulse_options(stored(writer));
  EXPECT_EQ(read.modulation, 0.5);
  EXPECT_EQ(read.largest_level_db, 3);
  EXPECT_EQ(read.lowest_part, 1.0 / 6);
  options.lowest_part = 0.95;
  EXPECT_ERROR(require_order(options), Exit::usage, "--resonance-from is above --resonance-to");
}

}  // namespace
}  // namespace piae::zero
