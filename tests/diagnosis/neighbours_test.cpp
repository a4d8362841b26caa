#include "diagnosis/neighbours.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"

namespace piae::diagnosis {
namespace {

BandPowers random_bands(Eigen::Index rows, const std::string& stream_name) {
  Stream stream(stream_name);
  BandPowers bands(rows, number_of_bands);
  for (Eigen::Index i = 0; i < bands.size(); ++i) bands.data()[i] = stream.normal(0, 3);
  return bands;
}

TEST(Neighbours, AreAsFarAsTheSumOfSquaresSays) {
  const BandPowers known = random_bands(5, "known");
  const BandPowers asked = random_bands(3, "asked");
  const Neighbours neighbours(known);
  EXPECT_EQ(neighbours.known(), known);
  const Eigen::MatrixXd squares = neighbours.squared_distances(asked);
  ASSERT_EQ(squares.rows(), 5);
  ASSERT_EQ(squares.cols(), 3);
  for (Eigen::Index i = 0; i < 5; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j) {
      double sum = 0;
      for (Eigen::Index band = 0; band < number_of_bands; ++band) {
        sum += (known(i, band) - asked(j, band)) * (known(i, band) - asked(j, band));
      }
      EXPECT_NEAR(squares(i, j), sum, 1e-10 * sum);
    }
  }
}

TEST(Neighbours, AreNeverNearerThanNothing) {
  const BandPowers known = random_bands(20, "known");
  const Eigen::MatrixXd squares = Neighbours(known).squared_distances(known);
  EXPECT_GE(squares.minCoeff(), 0);
  EXPECT_LT(squares.diagonal().maxCoeff(), 1e-9);
}

}  // namespace
}  // namespace piae::diagnosis
