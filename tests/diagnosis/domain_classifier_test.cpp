// Compares the gradients of the domain classifier, and of the network against it, with finite
// differences in double precision.

#include "diagnosis/domain_classifier.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "diagnosis/adversary.hpp"
#include "diagnosis/expect_slopes.hpp"
#include "diagnosis/random_batch.hpp"
#include "diagnosis/wdcnn_network.hpp"
#include "support/differences.hpp"

namespace piae::diagnosis {
namespace {

using Domains = DomainClassifier<double>;
using Network = WdcnnNetwork<double>;

/// The batch of these tests.
struct Shape {
  static constexpr std::int64_t classes = 3;
  static constexpr std::int64_t windows = 6;
  static constexpr std::int64_t labelled = 3;
};
constexpr double reversal = 0.7;

/// Hidden units and logits of a batch, as WDCNN holds them.
struct Example {
  Example() {
    Stream stream("example");
    for (double& x : hidden) x = stream.normal(0, 1);
    for (double& x : logits) x = stream.normal(0, 1);
  }
  [[nodiscard]] Domains::Batch batch() const {
    return {.hidden = {hidden.data(), 104},
            .logits = {logits.data(), 8},
            .windows = Shape::windows,
            .labelled = Shape::labelled};
  }
  std::vector<double> hidden = std::vector<double>(Shape::windows * 104);
  std::vector<double> logits = std::vector<double>(Shape::windows * 8);
};

class DomainClassifierOf : public testing::TestWithParam<Adaptation> {
 protected:
  [[nodiscard]] static Domains make() {
    return {GetParam(), Shape::classes, Shape::windows, Stream("domains")};
  }
};

/// Returns the loss of a batch, and the reversed gradient if it is wanted.
double loss_of(Domains domains, const Domains::Batch& batch, std::vector<double>* gradient = {}) {
  std::vector<double> unused(Shape::windows * 112);
  std::vector<double>& to = gradient == nullptr ? unused : *gradient;
  return domains.step(batch, 1e-3, reversal, {to.data(), batch.hidden.stride});
}

TEST_P(DomainClassifierOf, ReversesTheGradientByHiddenUnits) {
  Example example;
  std::vector<double> gradient(Shape::windows * 104);
  loss_of(make(), example.batch(), &gradient);
  Stream stream("places");
  for (int sample = 0; sample < 30; ++sample) {
    const std::size_t i = stream.below(Shape::windows) * 104 + stream.below(100);
    const double slope = central_difference(example.hidden[i], 1e-6,
                                            [&] { return loss_of(make(), example.batch()); });
    EXPECT_NEAR(gradient[i], -reversal * slope, 1e-9 + 1e-6 * std::abs(slope)) << i;
  }
}

// After its first step, Adam's first moment is a tenth of the gradient.
TEST_P(DomainClassifierOf, GradientByItsOwnWeightsEqualsFiniteDifferences) {
  using Kept = nets::Parameters<double>::Kept;
  const Example example;
  Domains stepped = make();
  std::vector<double> unused(Shape::windows * 104);
  stepped.step(example.batch(), 1e-3, reversal, {unused.data(), 104});
  Stream stream("weights");
  for (const nets::Parameters<double>::Parameter& parameter : stepped.parameters().parameters()) {
    for (int sample = 0; sample < 8; ++sample) {
      const std::int64_t j =
          parameter.begin +
          static_cast<std::int64_t>(stream.below(parameter.rows)) * parameter.held_columns +
          static_cast<std::int64_t>(stream.below(parameter.columns));
      double moved = make().parameters().data(Kept::value)[j];
      const double slope = central_difference(moved, 1e-6, [&] {
        Domains domains = make();
        domains.parameters().data(Kept::value)[j] = moved;
        return domains.step(example.batch(), 1e-3, reversal, {unused.data(), 104});
      });
      EXPECT_NEAR(stepped.parameters().data(Kept::first_moment)[j] / 0.1, slope,
                  1e-9 + 1e-6 * std::abs(slope))
          << parameter.spec.name;
    }
  }
}

// The whole: the cross-entropy of the labelled windows, minus the weighted loss of the domain
// classifier, whose class probabilities are constants.
TEST_P(DomainClassifierOf, NetworkFollowsBothLosses) {
  const RandomBatch batch = random_batch(Shape::windows, 1024, Shape::classes, "windows");
  const auto labels = std::span(batch.labels).first(Shape::labelled);
  Network network(1024, Shape::classes, Shape::windows, Stream("network"));
  const auto seen = [&](const std::vector<double>& logits) {
    return Domains::Batch{.hidden = {network.hidden(), network.hidden_row()},
                          .logits = {logits.data(), network.logits_row()},
                          .windows = Shape::windows,
                          .labelled = Shape::labelled};
  };
  const auto forward = [&] { return network.forward(batch.windows, Network::Mode::training); };
  const double* const first = forward();
  const std::vector<double> logits(first, first + Shape::windows * network.logits_row());
  std::vector<double> by_hidden(static_cast<std::size_t>(Shape::windows * network.hidden_row()));
  loss_of(make(), seen(logits), &by_hidden);
  network.backward(labels, by_hidden);

  const auto loss = [&] {
    forward();
    const double domain_loss = loss_of(make(), seen(logits));
    return network.backward(labels).loss / Shape::labelled - reversal * domain_loss;
  };
  expect_slopes(network, loss);
}

// By hand: equal outputs cost ln 2, whatever the windows.
TEST_P(DomainClassifierOf, AGuessCostsOneBit) {
  using Kept = nets::Parameters<double>::Kept;
  Domains domains = make();
  for (const auto& parameter : domains.parameters().parameters()) {
    std::fill_n(domains.parameters().data(Kept::value) + parameter.begin,
                parameter.rows * parameter.held_columns, 0.0);
  }
  const Example example;
  std::vector<double> unused(Shape::windows * 104);
  EXPECT_DOUBLE_EQ(domains.step(example.batch(), 1e-3, 1, {unused.data(), 104}), std::log(2.0));
}

TEST_P(DomainClassifierOf, LearnsToTellDomainsApartWithoutOverflow) {
  Domains domains = make();
  Example example;
  for (std::size_t i = 0; i < Shape::labelled * 104; ++i) example.hidden[i] += 1e4;
  std::vector<double> gradient(Shape::windows * 104);
  double loss = 0;
  for (int i = 0; i < 200; ++i) {
    loss = domains.step(example.batch(), 1e-3, 1, {gradient.data(), 104});
    ASSERT_TRUE(std::isfinite(loss));
  }
  EXPECT_LT(loss, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Adaptations, DomainClassifierOf,
                         testing::Values(Adaptation::marginal, Adaptation::conditional),
                         [](const auto& info) {
                           return info.param == Adaptation::marginal ? "Dann" : "Cdan";
                         });

// 2 / (1 + e^(-10 p)) - 1, by a calculator.
TEST(Reversal, GrowsAsInGaninsPaper) {
  EXPECT_EQ(reversal_at(0), 0);
  EXPECT_NEAR(reversal_at(0.1), 0.462117, 1e-6);
  EXPECT_NEAR(reversal_at(0.5), 0.986614, 1e-6);
  EXPECT_NEAR(reversal_at(1), 0.999909, 1e-6);
}

TEST(Adversary, DrawsEachUnlabelledWindowOnceAPass) {
  std::vector<float> unlabelled(7 * 1024);
  for (std::size_t i = 0; i < unlabelled.size(); ++i) unlabelled[i] = static_cast<float>(i / 1024);
  Adversary adversary(
      {.adaptation = Adaptation::marginal, .unlabelled = unlabelled, .stream = Stream("order")},
      1024, Shape::classes, 7, 2, 1e-3, Stream("initial"));
  const std::vector<float> source(1024, -1);
  const std::vector<const float*> batch(7, source.data());
  std::vector<std::vector<float>> passes;
  for (int pass = 0; pass < 2; ++pass) {
    const auto joined = adversary.joined(batch);
    ASSERT_EQ(joined.size(), 14U);
    std::vector<float>& drawn = passes.emplace_back();
    for (std::size_t i = 0; i < 14; ++i) {
      if (i < 7) {
        EXPECT_EQ(joined[i], source.data());
      } else {
        drawn.push_back(*joined[i]);
      }
    }
  }
  EXPECT_NE(passes[0], passes[1]);
  for (std::vector<float>& drawn : passes) {
    std::ranges::sort(drawn);
    EXPECT_EQ(drawn, (std::vector<float>{0, 1, 2, 3, 4, 5, 6}));
  }
}

}  // namespace
}  // namespace piae::diagnosis
