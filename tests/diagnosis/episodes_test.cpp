#include "diagnosis/episodes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace piae::diagnosis {
namespace {

/// Returns the indices of classes with so many windows each: 0, 1, ... in turn.
std::vector<std::vector<std::size_t>> classes_of_sizes(const std::vector<std::size_t>& sizes) {
  std::vector<std::vector<std::size_t>> windows_of;
  std::size_t next = 0;
  for (const std::size_t size : sizes) {
    std::vector<std::size_t>& own = windows_of.emplace_back();
    for (std::size_t i = 0; i < size; ++i) own.push_back(next++);
  }
  return windows_of;
}

// By hand: 100 windows give 5 + 5, nine give 5 + 4, five give 3 + 2, two give 1 + 1, one gives 1.
TEST(Episode, DrawsFewerWindowsOfSmallClasses) {
  Stream random("sizes");
  const Episode episode = draw_episode(classes_of_sizes({100, 9, 5, 2, 1}), {}, random);
  const auto count = [](const std::vector<Label>& labels, Label label) {
    return std::ranges::count(labels, label);
  };
  const std::vector<std::int64_t> shots{5, 5, 3, 1, 1};
  const std::vector<std::int64_t> queries{5, 4, 2, 1, 0};
  for (Label label = 0; label < 5; ++label) {
    const auto c = static_cast<std::size_t>(label);
    EXPECT_EQ(count(episode.support_labels, label), shots[c]) << label;
    EXPECT_EQ(count(episode.query_labels, label), queries[c]) << label;
  }
}

TEST(Episode, WindowsAreDistinctAndOfTheirClass) {
  const auto windows_of = classes_of_sizes({12, 5});
  Stream random("distinct");
  std::set<std::size_t> drawn;
  for (int i = 0; i < 50; ++i) {
    const Episode episode = draw_episode(windows_of, {}, random);
    std::set<std::size_t> own;
    const auto expect_own = [&](const std::vector<std::size_t>& windows,
                                const std::vector<Label>& labels) {
      ASSERT_EQ(windows.size(), labels.size());
      for (std::size_t k = 0; k < windows.size(); ++k) {
        EXPECT_TRUE(own.insert(windows[k]).second);
        EXPECT_EQ(labels[k], windows[k] < 12 ? 0 : 1);
      }
    };
    expect_own(episode.support, episode.support_labels);
    expect_own(episode.queries, episode.query_labels);
    drawn.merge(own);
  }
  EXPECT_EQ(drawn.size(), 17U);  // every window has its turn
}

/// Two classes on a line: the support at 0 and 2 of class 0 and at 5 of class 1; queries at 2
/// and 4.
struct ByHand {
  Episode episode{
      .support = {0, 1, 2}, .support_labels = {0, 0, 1}, .queries = {3, 4}, .query_labels = {0, 1}};
  Embeddings embeddings{{0}, {2}, {5}, {2}, {4}};
};

// Prototypes are 1 and 5. Query 2 has the squared distances 1 and 9: loss ln(1 + exp(-8)). Query 4
// has 9 and 1, the same loss. Both are right.
TEST(EpisodeLoss, IsTheCrossEntropyOfDistancesToMeans) {
  const ByHand made;
  Embeddings gradient;
  const BatchOutcome outcome = episode_loss(made.episode, 2, made.embeddings, gradient);
  EXPECT_NEAR(outcome.loss, 2 * std::log1p(std::exp(-8.0)), 1e-12);
  EXPECT_EQ(outcome.correct, 2);
}

// By hand: the wrong class of each query has the probability p = 1 / (1 + exp(8)). The mean loss
// has the derivative -p/2 by the logit of the right class and p/2 by the other. Query 2: (-p/2)
// (-2) (2 - 1) + (p/2) (-2) (2 - 5) =  4 p, and by symmetry -4 p by query 4. Prototype 1:  (-p/2) 2
// (2 - 1) + (p/2) 2 (4 - 1)       =  2 p, half of it by each of its windows. Prototype 5:  (p/2) 2
// (2 - 5) + (-p/2) 2 (4 - 5)       = -2 p
TEST(EpisodeLoss, HasTheGradientWorkedByHand) {
  const ByHand made;
  Embeddings gradient;
  (void)episode_loss(made.episode, 2, made.embeddings, gradient);
  const double p = 1 / (1 + std::exp(8.0));
  const double expected[] = {p, p, -2 * p, 4 * p, -4 * p};
  ASSERT_EQ(gradient.rows(), 5);
  for (Eigen::Index i = 0; i < 5; ++i) EXPECT_NEAR(gradient(i, 0), expected[i], 1e-12) << i;
}

TEST(EpisodeLoss, GradientMatchesFiniteDifferences) {
  Stream random("gradient");
  const Episode episode = draw_episode(classes_of_sizes({20, 5, 3, 1}), {}, random);
  const auto rows = std::ssize(episode.support) + std::ssize(episode.queries);
  Embeddings embeddings(rows, 3);
  for (double& x : embeddings.reshaped()) x = random.normal(0, 1);
  const auto mean_loss = [&](const Embeddings& at) {
    Embeddings unused;
    return episode_loss(episode, 4, at, unused).loss / static_cast<double>(episode.queries.size());
  };
  Embeddings gradient;
  (void)episode_loss(episode, 4, embeddings, gradient);
  constexpr double step = 1e-5;
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j) {
      Embeddings above = embeddings;
      Embeddings below = embeddings;
      above(i, j) += step;
      below(i, j) -= step;
      EXPECT_NEAR(gradient(i, j), (mean_loss(above) - mean_loss(below)) / (2 * step), 1e-8)
          << i << ", " << j;
    }
  }
}

TEST(DistanceLogits, AreMinusSquaredDistances) {
  const Embeddings logits = distance_logits(Embeddings{{0, 1}}, Embeddings{{3, 5}, {0, 1}});
  EXPECT_EQ(logits(0, 0), -25);
  EXPECT_EQ(logits(0, 1), 0);
}

}  // namespace
}  // namespace piae::diagnosis
