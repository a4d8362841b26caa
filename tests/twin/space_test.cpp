#include "twin/space.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "base/error.hpp"
#include "support/three_classes.hpp"

namespace piae::twin {
namespace {

const std::vector<TwinPoint> four_points{{1, 10}, {1.2, 10}, {3, 10}, {5, 50}};

TEST(TwinSpace, CountsPointsInBinsOfEqualWidth) {
  const TwinSpace space(four_points, 2);
  EXPECT_EQ(space.k_edges(), (std::vector<double>{1, 3, 5}));
  EXPECT_EQ(space.c_edges(), (std::vector<double>{10, 30, 50}));
  // k = 3 lies on the edge and belongs to the upper bin; the largest value belongs to the last bin.
  EXPECT_EQ(space.counts(), (std::vector<std::int64_t>{2, 0, 1, 1}));
}

TEST(TwinSpace, SamplesBinsByTheirFrequency) {
  const TwinSpace space(four_points, 2);
  Stream stream("space");
  std::map<std::pair<bool, bool>, int> seen;
  constexpr int draws = 40000;
  for (int i = 0; i < draws; ++i) {
    const TwinPoint point = space.sample(stream);
    ASSERT_GE(point.k, 1);
    ASSERT_LE(point.k, 5);
    ++seen[{point.k >= 3, point.c >= 30}];
  }
  const auto share = [&](bool k, bool c) { return seen[{k, c}] / static_cast<double>(draws); };
  EXPECT_NEAR(share(false, false), 0.50, 0.01);
  EXPECT_NEAR(share(true, false), 0.25, 0.01);
  EXPECT_NEAR(share(true, true), 0.25, 0.01);
  EXPECT_EQ((seen[{false, true}]), 0);
}

TEST(TwinSpace, EqualPointsGiveThatPoint) {
  const TwinSpace space({{2, 7}, {2, 7}}, 10);
  Stream stream("equal");
  const TwinPoint point = space.sample(stream);
  EXPECT_EQ(point.k, 2);
  EXPECT_EQ(point.c, 7);
}

TEST(TwinSpace, IsReadAsWritten) {
  const auto path = std::filesystem::path(testing::TempDir()) / "space.h5";
  artefact::Writer writer("model");
  const TwinSpace written(four_points, 3);
  written.write(writer);
  writer.save(path, {});
  const TwinSpace read{artefact::Reader(path, "model")};
  EXPECT_EQ(read.k_edges(), written.k_edges());
  EXPECT_EQ(read.c_edges(), written.c_edges());
  EXPECT_EQ(read.counts(), written.counts());
  EXPECT_EQ(read.points().size(), 4U);
}

TEST(TwinSpace, RefusesAnEmptyHistogram) {
  const auto path = std::filesystem::path(testing::TempDir()) / "empty_space.h5";
  artefact::Writer writer("model");
  writer.numbers("/twin_space/points", std::vector<double>{1, 2}, {1, 2});
  writer.numbers("/twin_space/k_edges", std::vector<double>{1, 2});
  writer.numbers("/twin_space/c_edges", std::vector<double>{1, 2});
  writer.numbers("/twin_space/counts", std::vector<std::int64_t>{0}, {1, 1});
  writer.save(path, {});
  EXPECT_THROW(TwinSpace{artefact::Reader(path, "model")}, Error);
}

const std::vector<Label> labels_of_two{1, 1, 2, 2};

ClassSpaces stored(const std::string& name, const std::vector<Label>& labels) {
  const auto path = std::filesystem::path(testing::TempDir()) / name;
  artefact::Writer writer("model");
  signal::write(writer, three_classes());
  TwinSpace(four_points, 3).write(writer);
  if (!labels.empty()) write_labels_of_space(writer, labels);
  writer.save(path, {});
  return ClassSpaces(artefact::Reader(path, "model"));
}

TEST(ClassSpaces, ShareOneSpaceWithoutLabels) {
  const ClassSpaces spaces = stored("one_space.h5", {});
  EXPECT_EQ(spaces.of(1).counts(), TwinSpace(four_points, 3).counts());
  EXPECT_EQ(spaces.of(2).k_edges(), TwinSpace(four_points, 3).k_edges());
}

TEST(ClassSpaces, SeparateClassesWithLabels) {
  const ClassSpaces spaces = stored("class_spaces.h5", labels_of_two);
  const TwinSpace own({four_points[2], four_points[3]}, 3);
  EXPECT_EQ(spaces.of(2).counts(), own.counts());
  EXPECT_EQ(spaces.of(2).k_edges(), own.k_edges());
  EXPECT_EQ(spaces.of(2).points().size(), 2U);
}

TEST(ClassSpaces, RefuseAClassWithoutWindows) {
  for (const std::vector<Label>& labels : {std::vector<Label>{1, 1, 1, 1}, {1, 1, 2, 3}}) {
    EXPECT_THROW((void)stored("no_window.h5", labels), artefact::Refusal);
  }
}

}  // namespace
}  // namespace piae::twin
