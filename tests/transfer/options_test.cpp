#include "transfer/options.hpp"

#include <gtest/gtest.h>

#include "support/checkpoints.hpp"
#include "support/command_line.hpp"
#include "support/errors.hpp"

namespace piae::transfer {
namespace {

TEST(CarryOptions, AreReadAsWritten) {
  CarryOptions options;
  cli::parse(
      "--response cut --edges known --rhythm known --strengths alike --own-structure 0.25 "
      "--background 0.5 --background-from healthy --dispersion-ms 0.75 --strike-jitter 0.01 "
      "--lag-deviation 0.03 --tilt 2 "
      "--size-factor 3 --equaliser-db 4 --equaliser-knots 5 --other-bearing-db 7 --mass-kg 2 "
      "--load-zone-from 0.3 --load-zone-to 0.6 --rotating-load 0.4 --strength-scatter 0.7",
      [&](const cli::Options& command) { bind(command, options); });
  artefact::Writer writer("model");
  table_of(options).write(writer);
  const std::filesystem::path path = scratch_file("options.h5");
  writer.save(path, {});
  CarryOptions read;
  table_of(read).read(artefact::Reader(path, "model"));
  EXPECT_EQ(read.response, Response::cut);
  EXPECT_EQ(read.edges, Set::known);
  EXPECT_EQ(read.rate_of, Set::known);
  EXPECT_EQ(read.strengths.from, Strengths::alike);
  EXPECT_EQ(read.strengths.load.least_extent, 0.3);
  EXPECT_EQ(read.strengths.load.largest_extent, 0.6);
  EXPECT_EQ(read.strengths.load.rotating, 0.4);
  EXPECT_EQ(read.strengths.load.scatter, 0.7);
  EXPECT_EQ(read.background_from, BackgroundFrom::healthy);
  EXPECT_EQ(read.other_bearing_db, 7);
  EXPECT_EQ(read.mass_kg, 2);
  EXPECT_EQ(read.own_structure, 0.25);
  EXPECT_EQ(read.background, 0.5);
  EXPECT_EQ(read.dispersion_ms, 0.75);
  EXPECT_EQ(read.jitter, 0.01);
  EXPECT_EQ(read.lag_deviation, 0.03);
  EXPECT_EQ(read.tilt, 2);
  EXPECT_EQ(read.size_factor, 3);
  EXPECT_EQ(read.equaliser.spread_db, 4);
  EXPECT_EQ(read.equaliser.knots, 5);
}

TEST(CarryOptions, RefuseAReversedLoadZone) {
  CarryOptions options;
  options.strengths.load = {.least_extent = 0.8, .largest_extent = 0.4};
  EXPECT_ERROR(require_sense(options, {}, {}), Exit::usage,
               "--load-zone-from must not be above --load-zone-to");
  artefact::Writer writer("model");
  table_of(options).write(writer);
  writer.save(scratch_file("zone.h5"), {});
  EXPECT_ERROR(table_of(options).read({scratch_file("zone.h5"), "model"}), Exit::bad_input,
               "/strengths, attribute least_extent is above largest_extent");
}

}  // namespace
}  // namespace piae::transfer
