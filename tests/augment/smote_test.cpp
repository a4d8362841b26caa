#include <algorithm>

#include "augment/interpolation.hpp"
#include "augment/methods.hpp"
#include "augment/places.hpp"
#include "base/error.hpp"
#include "support/errors.hpp"

namespace piae::augment {
namespace {

/// Returns class IR: (0, 0), (2, 0), (0, 3), (4, 3), the windows of interpolation_test.cpp. Class
/// OR lies between them, so that neighbours across classes would show. A third sample, the same in
/// all windows, prevents constant windows.
signal::WindowSet four_of_a_class() {
  signal::WindowSet known;
  known.info = known_windows().info;
  known.length = 3;
  known.samples = {0, 0, 1.5, 2, 0, 1.5, 0, 3, 1.5, 4, 3, 1.5,
                   1, 1, 1.5, 1, 2, 1.5, 2, 1, 1.5, 2, 2, 1.5};
  known.labels = {1, 1, 1, 1, 2, 2, 2, 2};
  return known;
}

std::filesystem::path model_with(int neighbours) {
  return train("smote", "--neighbours " + std::to_string(neighbours), four_of_a_class(),
               checkpoint_at("checkpoint"), "model.h5");
}

/// Returns the position of a window between base (0) and neighbour (1), from the coordinate that
/// differs most; fails the test if the window is not on that line.
double place_between(Window base, Window neighbour, Window window) {
  const std::size_t t = std::abs(neighbour[0] - base[0]) > std::abs(neighbour[1] - base[1]) ? 0 : 1;
  const double gap = (window[t] - base[t]) / (neighbour[t] - base[t]);
  for (std::size_t s = 0; s < 2; ++s) {
    EXPECT_NEAR(window[s], base[s] + gap * (neighbour[s] - base[s]), 1e-6);
  }
  return gap;
}

TEST(Smote, WithOneNeighbourInterpolatesToTheNearest) {
  // From the table by hand: (0,0) -> (2,0), (2,0) -> (0,0), (0,3) -> (0,0), (4,3) -> (2,0). The
  // known windows take turns as the base.
  const std::size_t nearest[] = {1, 0, 0, 1};
  const signal::WindowSet known = four_of_a_class();
  const signal::WindowSet windows = generate("smote", model_with(1), 400);
  std::vector<double> gaps;
  for (std::size_t i = 0; i < 400; ++i) {
    gaps.push_back(
        place_between(known.window(i % 4), known.window(nearest[i % 4]), windows.window(i)));
  }
  std::ranges::sort(gaps);
  // Uniform in [0, 1): the Kolmogorov distance of 400 numbers is below 0.0979 in 99.9 % of cases.
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    EXPECT_NEAR(gaps[i], static_cast<double>(i) / 400, 0.0979);
  }
  EXPECT_GE(gaps.front(), 0);
  EXPECT_LT(gaps.back(), 1);
}

TEST(Smote, DrawsEveryNeighbourAndNoOtherWindow) {
  // The two nearest of (0, 0) are (2, 0) and (0, 3): windows lie on one axis or the other.
  const signal::WindowSet windows = generate("smote", model_with(2), 400);
  int along_first = 0;
  for (std::size_t i = 0; i < 400; i += 4) {
    const Window window = windows.window(i);
    EXPECT_EQ(std::min(window[0], window[1]), 0);
    EXPECT_LT(window[0], 2);
    EXPECT_LT(window[1], 3);
    if (window[0] > 0) ++along_first;
  }
  EXPECT_NEAR(along_first, 50, 17);  // of 100; 3.3 standard deviations
}

TEST(Smote, FollowsItsRandomNumbersExactly) {
  const signal::WindowSet known = four_of_a_class();
  const signal::WindowSet windows = generate("smote", model_with(3), 6);
  // Window 5 of class IR: base (2, 0), with neighbours by distance (0,0), (0,3), (4,3).
  Stream random("generate/IR/5");
  const float neighbours[3][2] = {{0, 0}, {0, 3}, {4, 3}};
  const float* neighbour = neighbours[random.below(3)];
  const double gap = random.uniform(0, 1);
  EXPECT_EQ(windows.window(5)[0], static_cast<float>(2 + gap * (neighbour[0] - 2)));
  EXPECT_EQ(windows.window(5)[1], static_cast<float>(gap * neighbour[1]));
}

TEST(Smote, RecordsBothParentsOfEachWindow) {
  const signal::WindowSet known = four_of_a_class();
  const signal::WindowSet windows = generate("smote", model_with(3), 40);
  ASSERT_EQ(windows.parents.size(), 80U);
  for (std::size_t i = 0; i < 80; ++i) {
    ASSERT_EQ(windows.parents[i].size(), 2U) << i;
    const auto base = static_cast<std::size_t>(windows.parents[i][0]);
    const auto neighbour = static_cast<std::size_t>(windows.parents[i][1]);
    EXPECT_EQ(base, i % 40 % 4 + i / 40 * 4);
    EXPECT_EQ(known.labels[neighbour], windows.labels[i]);
    const double gap =
        place_between(known.window(base), known.window(neighbour), windows.window(i));
    EXPECT_GE(gap, 0);
    EXPECT_LT(gap, 1);
  }
}

TEST(Smote, StaysWithinTheClass) {
  const signal::WindowSet windows = generate("smote", model_with(3), 100);
  for (std::size_t i = 100; i < 200; ++i) {
    for (const float sample : windows.window(i)) {
      EXPECT_GE(sample, 1);
      EXPECT_LE(sample, 2);
    }
  }
}

void expect_refusal(const signal::WindowSet& known, int neighbours,
                    const std::vector<std::string>& words) {
  try {
    train("smote", "--neighbours " + std::to_string(neighbours), known, checkpoint_at("checkpoint"),
          "never.h5");
    FAIL() << "took " << neighbours << " neighbours";
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::usage);
    for (const std::string& word : words) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  }
}

TEST(Smote, NamesTheLargestPossibleNeighbours) {
  expect_refusal(four_of_a_class(), 4,
                 {"--neighbours 4", "IR", "4 known windows", "at most --neighbours 3"});
  signal::WindowSet uneven = four_of_a_class();
  uneven.samples.resize(18);
  uneven.labels.resize(6);
  expect_refusal(uneven, 3, {"--neighbours 3", "OR", "2 known windows", "at most --neighbours 1"});
}

TEST(Smote, NeedsTwoKnownWindows) {
  signal::WindowSet known = four_of_a_class();
  known.samples.resize(15);
  known.labels.resize(5);
  expect_refusal(known, 1, {"OR", "1 known window;", "at least 2"});
}

TEST(Smote, RefusesZeroNeighbours) {
  EXPECT_THROW(method_with("smote", "--neighbours 0"), cli::Refused);
  EXPECT_THROW(method_with("smote", "--neighbours 1.5"), cli::Refused);
}

/// Returns a model of a variant of SMOTE. `remark` gets the addition to the line of `train`.
std::filesystem::path variant_model(const std::string& method, const std::string& options,
                                    const signal::WindowSet& known,
                                    const signal::WindowSet& healthy,
                                    std::string* remark = nullptr) {
  artefact::Writer writer("model");
  const std::unique_ptr<Method> learner = method_with(method, "--neighbours 1 " + options);
  learner->use_healthy(healthy);
  learner->train(known, Stream("train"), {}, checkpoint_at("checkpoint"), writer);
  if (remark != nullptr) *remark = learner->remark();
  std::filesystem::path path = scratch_file(method + ".h5");
  writer.save(path, {});
  return path;
}

/// Returns how often each of the six known windows is a starting point.
std::vector<int> starts_of(const signal::WindowSet& windows) {
  std::vector<int> starts(6);
  for (const signal::Parents& parents : windows.parents) {
    ++starts.at(static_cast<std::size_t>(parents.at(0)));
  }
  return starts;
}

std::int64_t classes_as_smote(const std::filesystem::path& model) {
  return artefact::Reader(model, "model").integer("/", "classes_as_smote");
}

// starting_windows_test.cpp works the foreign neighbours of these windows: with m = 3 class IR has
// 1, 1, 2 and 3, class OR 3 and 3.
std::filesystem::path model_at_places(const std::string& method, const std::string& options,
                                      std::string* remark = nullptr) {
  return variant_model(method, options, known_at_places(), healthy_at_places(), remark);
}

TEST(Adasyn, StartsInProportionToTheForeignNeighbours) {
  std::string remark;
  const auto model = model_at_places("adasyn", "--foreign-among 3", &remark);
  EXPECT_EQ(starts_of(generate("adasyn", model, 700)),
            (std::vector<int>{100, 100, 200, 300, 350, 350}));
  EXPECT_EQ(classes_as_smote(model), 0);
  EXPECT_EQ(remark, "");
  // imbalanced-learn rounds 20 / 7 (1, 1, 2, 3) to 3, 3, 6 and 9, which are 21.
  const std::vector<int> starts = starts_of(generate("adasyn", model, 20));
  const int rounded[] = {3, 3, 6, 9};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(starts[i], rounded[i], 1) << i;
}

TEST(Adasyn, InterpolatesWithTheNearestOfItsClass) {
  const auto model = model_at_places("adasyn", "--foreign-among 3");
  const signal::WindowSet windows = generate("adasyn", model, 70);
  const float nearest[] = {1, 0, 1, 3};
  for (std::size_t i = 0; i < 70; ++i) {
    const auto base = static_cast<std::size_t>(windows.parents[i][0]);
    const float from = known_at_places().window(base)[0];
    const float place = windows.window(i)[0];
    EXPECT_GE(place, std::min(from, nearest[base]));
    EXPECT_LE(place, std::max(from, nearest[base]));
  }
}

TEST(BorderlineSmote, StartsInDangerOnly) {
  // 2 of 3 is in danger, 1 is safe and 3 is noise. Class OR has only noise.
  std::string remark;
  const auto model = model_at_places("borderline-smote", "--foreign-among 3", &remark);
  EXPECT_EQ(starts_of(generate("borderline-smote", model, 10)),
            (std::vector<int>{0, 0, 10, 0, 5, 5}));
  EXPECT_EQ(classes_as_smote(model), 1);
  EXPECT_EQ(remark, " (1 of them as smote: no window in danger)");
}

TEST(BorderlineSmote, CountsHalfOfThemAsDanger) {
  // The four nearest windows of each known one, by their places:
  //   IR  0: 1 3 4 5   IR  1: 0 3 4 5   IR  3: 4 1 5 0   IR  9: 10 11 5 4
  //   OR  4: 3 5 1 0   OR 10: 9 11 5 4
  const auto model = model_at_places("borderline-smote", "--foreign-among 4");
  EXPECT_EQ(
      artefact::Reader(model, "model").numbers<std::int64_t>("/foreign_neighbours", {6}).values,
      (std::vector<std::int64_t>{2, 2, 2, 4, 4, 3}));
  EXPECT_EQ(starts_of(generate("borderline-smote", model, 6)),
            (std::vector<int>{2, 2, 2, 0, 0, 6}));
  EXPECT_EQ(classes_as_smote(model), 0);
}

TEST(SmoteVariants, AreSmoteWithoutAForeignNeighbour) {
  const signal::WindowSet known = at_places({{1, 0}, {1, 1}, {1, 3}, {1, 9}, {2, 100}, {2, 101}});
  const signal::WindowSet healthy = at_places({{0, 1000}, {0, 1001}});
  const auto smote =
      train("smote", "--neighbours 1", known, checkpoint_at("checkpoint"), "smote.h5");
  const std::vector<float> expected = generate("smote", smote, 30).samples;
  for (const std::string method : {"adasyn", "borderline-smote"}) {
    std::string remark;
    const auto model = variant_model(method, "--foreign-among 1", known, healthy, &remark);
    EXPECT_EQ(generate(method, model, 30).samples, expected) << method;
    EXPECT_EQ(classes_as_smote(model), 2) << method;
    EXPECT_EQ(remark.rfind(" (2 of them as smote: no ", 0), 0U) << remark;
  }
}

TEST(SmoteVariants, HaveTheDefaultsOfImbalancedLearn) {
  signal::WindowSet healthy = at_places({});
  for (int i = 0; i < 10; ++i) healthy.append(at_places({{0, 20.0F + static_cast<float>(i)}}), 0);
  const auto among = [&](const std::string& method) {
    return artefact::Reader(variant_model(method, "", known_at_places(), healthy), "model")
        .integer("/", "foreign_among");
  };
  EXPECT_EQ(among("adasyn"), 5);
  EXPECT_EQ(among("borderline-smote"), 10);
}

TEST(SmoteVariants, NeedHealthyWindowsAndEnoughOfThem) {
  for (const std::string method : {"adasyn", "borderline-smote"}) {
    artefact::Writer writer("model");
    EXPECT_ERROR(
        method_with(method, "--neighbours 1")
            ->train(known_at_places(), Stream("train"), {}, checkpoint_at("checkpoint"), writer),
        Exit::usage, "give --healthy B.h5");
    EXPECT_ERROR(model_at_places(method, "--foreign-among 8"), Exit::usage,
                 "give at most --foreign-among 7");
    EXPECT_THROW(method_with(method, "--foreign-among 0"), cli::Refused);
    EXPECT_THROW(method_with(method, "--neighbours 0"), cli::Refused);
  }
}

/// Returns a model of `adasyn` or `borderline-smote` such as no training writes.
std::filesystem::path damaged_variant(std::int64_t among, const std::vector<std::int64_t>& foreign,
                                      std::int64_t as_smote) {
  artefact::Writer writer("model");
  signal::write(writer, known_at_places());
  writer.attribute("/", "neighbours", std::int64_t{1});
  writer.attribute("/", "foreign_among", among);
  writer.numbers("/foreign_neighbours", foreign);
  writer.attribute("/", "classes_as_smote", as_smote);
  std::filesystem::path path = scratch_file("damaged.h5");
  writer.save(path, {});
  return path;
}

TEST(SmoteVariants, RefuseADamagedModel) {
  const auto refuse = [](const std::filesystem::path& model, const std::string& word) {
    EXPECT_ERROR(generate("adasyn", model, 1), Exit::bad_input, word);
  };
  EXPECT_EQ(generate("adasyn", damaged_variant(3, {1, 1, 2, 3, 3, 3}, 0), 1).size(), 2U);
  refuse(damaged_variant(0, {0, 0, 0, 0, 0, 0}, 2), "foreign_among");
  refuse(damaged_variant(std::int64_t{1} << 40, {1, 1, 2, 3, 3, 3}, 0), "foreign_among");
  refuse(damaged_variant(3, {1, 1, 2, 3, 3, 4}, 0), "/foreign_neighbours");
  refuse(damaged_variant(3, {1, 1, 2, 3, 3, -1}, 0), "/foreign_neighbours");
  refuse(damaged_variant(3, {1, 1, 2, 3, 3}, 0), "/foreign_neighbours");
  refuse(damaged_variant(3, {1, 1, 2, 3, 3, 3}, 1), "must be 0");
  refuse(damaged_variant(3, {1, 1, 2, 3, 0, 0}, 0), "must be 1");
}

}  // namespace
}  // namespace piae::augment
