#include "transfer/structure.hpp"

#include <gtest/gtest.h>

#include "transfer/carried.hpp"

namespace piae::transfer {
namespace {

double root_mean_square(const Eigen::ArrayXd& values) { return std::sqrt(values.square().mean()); }

TEST(Structure, IsCommonToTheBearingsOfOneMachine) {
  const signal::WindowSet known = one_machine();
  std::vector<impacts::Edges> edges;
  for (std::size_t i = 0; i < known.size(); ++i) {
    edges.push_back(edges_at(known, i, lag_shares[i / 5], 1200));
  }
  const Structure structure = structure_of(known, edges);
  ASSERT_EQ(structure.common.size(), 1025);
  const Eigen::ArrayXd truth = three_resonances(1025, 12000);
  // The lowest frequencies are left out, because windows without their mean show little there. 20
  // windows scatter: away from the edges' minima, the structure shows to 1 dB (0.115).
  const auto band = [](const Eigen::ArrayXd& curve) {
    const Eigen::ArrayXd part = curve.segment(150, 800);
    return Eigen::ArrayXd(part - part.mean());
  };
  EXPECT_LT(root_mean_square(band(structure.common) - band(truth)), 0.115);
  EXPECT_GT(root_mean_square(band(truth)), 0.6);
  for (const Eigen::ArrayXd& own : structure.own) EXPECT_LT(root_mean_square(band(own)), 0.2);
}

}  // namespace
}  // namespace piae::transfer
