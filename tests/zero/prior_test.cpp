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
  cli::parse(line, [&](const cli::Options& command) { table_of(prior).bind(command); });
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
  EXPECT_EQ(prior.random_impacts, 0.25);
  EXPECT_EQ(prior.least_on_track, 1);
  EXPECT_EQ(prior.other_race, 1);
  EXPECT_EQ(prior.load_zone, Switch::off);
  EXPECT_EQ(prior.edges, Switch::off);
  EXPECT_EQ(prior.resonances, 1);
  EXPECT_EQ(prior.healthy_structure, 0);
  EXPECT_EQ(prior.least_level_db, -5);
  EXPECT_EQ(prior.largest_size_mm, 2);
  EXPECT_EQ(prior.stray_impacts, 0);
  EXPECT_THROW(prior_of("--slip 0.5"), cli::Refused);
  EXPECT_THROW(prior_of("--damping-ratio-from 0"), cli::Refused);
  EXPECT_THROW(prior_of("--resonances 0"), cli::Refused);
  EXPECT_THROW(prior_of("--edges maybe"), cli::Refused);
}

TEST(PriorOptions, AreStoredAndRead) {
  Prior prior = prior_of("--jitter 0.001 --load-zone off --resonances 3");
  artefact::Writer writer("model");
  table_of(prior).write(writer);
  Prior read;
  table_of(read).read(stored(writer));
  EXPECT_EQ(read.jitter, 0.001);
  EXPECT_EQ(read.load_zone, Switch::off);
  EXPECT_EQ(read.edges, Switch::on);
  EXPECT_EQ(read.resonances, 3);
  EXPECT_EQ(read.largest_level_db, Prior{}.largest_level_db);
  prior = prior_of("--size-from-mm 3 --size-to-mm 2");
  EXPECT_ERROR(table_of(prior).require_order(), Exit::usage,
               "--size-from-mm must not be above --size-to-mm");
}

TEST(ImpulseOptions, AreStoredAndRead) {
  ImpulseOptions options{.lowest_part = 0.5, .modulation = 0.5};
  artefact::Writer writer("model");
  table_of(options).write(writer);
  ImpulseOptions read;
  table_of(read).read(stored(writer));
  EXPECT_EQ(read.lowest_part, 0.5);
  EXPECT_EQ(read.modulation, 0.5);
  options.lowest_part = 0.95;
  EXPECT_ERROR(table_of(options).require_order(), Exit::usage,
               "--resonance-from must not be above --resonance-to");
}

}  // namespace
}  // namespace piae::zero
