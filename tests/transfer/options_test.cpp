#include "transfer/options.hpp"

#include <gtest/gtest.h>

#include "support/checkpoints.hpp"
#include "support/command_line.hpp"
#include "support/errors.hpp"
#include "transfer/stored_edges.hpp"

namespace piae::transfer {
namespace {

TEST(CarryOptions, AreReadAsTheyWereWritten) {
  CarryOptions options;
  cli::parse(
      "--response cut --edges known --rhythm known --strengths alike --own-structure 0.25 "
      "--background 0.5 --background-from healthy --dispersion-ms 0.75 --strike-jitter 0.01 "
      "--lag-deviation 0.03 --tilt 2 "
      "--size-factor 3 --equaliser-db 4 --equaliser-knots 5 --other-bearing-db 7 --mass-kg 2 "
      "--load-zone-from 0.3 --load-zone-to 0.6 --rotating-load 0.4 --strength-scatter 0.7",
      [&](const cli::Options& command) { bind(command, options); });
  artefact::Writer writer("model");
  write(writer, options);
  const std::filesystem::path path = scratch_file("options.h5");
  writer.save(path, {});
  const CarryOptions read = read_carry_options(artefact::Reader(path, "model"));
  EXPECT_EQ(read.response, Response::cut);
  EXPECT_EQ(read.edges, Set::known);
  EXPECT_EQ(read.rhythm, Set::known);
  EXPECT_EQ(read.strengths.from, Strengths::alike);
  EXPECT_EQ(read.strengths.least_extent, 0.3);
  EXPECT_EQ(read.strengths.largest_extent, 0.6);
  EXPECT_EQ(read.strengths.rotating, 0.4);
  EXPECT_EQ(read.strengths.scatter, 0.7);
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

TEST(CarryOptions, OfAWordThatNoOneKnowsAreRefused) {
  artefact::Writer writer("model");
  writer.group("/carry");
  writer.attribute("/carry", "response", std::string("loud"));
  const std::filesystem::path path = scratch_file("loud.h5");
  writer.save(path, {});
  EXPECT_ERROR(read_carry_options(artefact::Reader(path, "model")), Exit::bad_input,
               "attribute response is loud, must be minimum-phase or ring or cut");
}

TEST(StoredEdges, AreReadAsTheyWereWrittenAndRefusedWhereTheyCannotBe) {
  const auto stored = [](const std::vector<Edges>& edges) {
    artefact::Writer writer("model");
    write(writer, edges);
    const std::filesystem::path path = scratch_file("edges.h5");
    writer.save(path, {});
    return artefact::Reader(path, "model");
  };
  const std::vector<Edges> edges{{.lag_s = 1e-3, .exit = 0.5, .spread = 0.02},
                                 {.lag_s = 2e-3, .exit = 0.25, .spread = 0}};
  const std::vector<Edges> read = read_edges(stored(edges), 2);
  EXPECT_EQ(read[1].lag_s, 2e-3);
  EXPECT_EQ(read[1].exit, 0.25);
  EXPECT_EQ(read[0].spread, 0.02);
  EXPECT_ERROR(read_edges(stored(edges), 3), Exit::bad_input, "/edges/lag_s");
  EXPECT_ERROR(read_edges(stored({{.lag_s = -1}}), 1), Exit::bad_input, "/edges/lag_s");
  EXPECT_ERROR(read_edges(stored({{.lag_s = 1e-3, .exit = 2}}), 1), Exit::bad_input, "/edges/exit");
}

}  // namespace
}  // namespace piae::transfer
