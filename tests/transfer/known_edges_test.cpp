#include "transfer/known_edges.hpp"

#include <gtest/gtest.h>

#include "support/checkpoints.hpp"
#include "support/errors.hpp"
#include "transfer/carried.hpp"

namespace piae::transfer {
namespace {

TEST(KnownEdges, AreFoundInWindowsOfOneMachine) {
  const signal::WindowSet known = one_machine();
  const std::vector<impacts::Edges> edges = edges_of_known(known, {});
  ASSERT_EQ(edges.size(), known.size());
  for (std::size_t i = 0; i < known.size(); ++i) {
    const double share = edges[i].lag_s / passage_s(known, i, known.size_mm(i), 1200);
    EXPECT_NEAR(share, lag_shares[i / 5], 0.035) << i;
    EXPECT_NEAR(edges[i].exit, 0.6, 0.26) << i;
    EXPECT_EQ(edges[i].lag_s, edges[i / 5 * 5].lag_s) << "windows of one bearing";
  }
}

/// Returns the machine of one_machine() without the size of class 1.
signal::WindowSet without_a_size() {
  signal::WindowSet known = one_machine();
  known.info.classes[1].defect_size_mm = 0;
  return known;
}

TEST(KnownEdges, AreMissingForAnUnknownSize) {
  const signal::WindowSet known = without_a_size();
  const std::vector<impacts::Edges> edges = edges_of_known(known, {});
  for (const std::size_t i : known.indices_of(1)) {
    EXPECT_EQ(edges[i].lag_s, 0);
    EXPECT_EQ(edges[i].exit, 0);
  }
  for (const std::size_t i : known.indices_of(2)) EXPECT_GT(edges[i].lag_s, 0);
}

TEST(StoredEdges, AreReadAsWrittenAndRefusedIfImpossible) {
  const auto stored = [](const std::vector<impacts::Edges>& edges) {
    artefact::Writer writer("model");
    write(writer, edges);
    const std::filesystem::path path = scratch_file("edges.h5");
    writer.save(path, {});
    return artefact::Reader(path, "model");
  };
  const std::vector<impacts::Edges> edges{{.lag_s = 1e-3, .exit = 0.5, .spread = 0.02},
                                          {.lag_s = 2e-3, .exit = 0.25, .spread = 0}};
  const std::vector<impacts::Edges> read = read_edges(stored(edges), 2);
  EXPECT_EQ(read[1].lag_s, 2e-3);
  EXPECT_EQ(read[1].exit, 0.25);
  EXPECT_EQ(read[0].spread, 0.02);
  EXPECT_ERROR(read_edges(stored(edges), 3), Exit::bad_input, "/edges/lag_s");
  EXPECT_ERROR(read_edges(stored({{.lag_s = -1}}), 1), Exit::bad_input, "/edges/lag_s");
  EXPECT_ERROR(read_edges(stored({{.lag_s = 1e-3, .exit = 2}}), 1), Exit::bad_input, "/edges/exit");
}

}  // namespace
}  // namespace piae::transfer
