#include "symptoms/symptoms.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace piae::symptoms {
namespace {

Measures with_levels(const Eigen::ArrayXd& levels_db) {
  Measures measures;
  measures.shape_db = Eigen::Array2d(1, 2);
  measures.levels_db = levels_db;
  return measures;
}

TEST(Symptoms, AreHeightsKurtosisRisesAndNovelty) {
  const Measures healthy = with_levels(Eigen::Array4d(-10, -20, -30, -40));
  const Baseline baseline(std::vector<const Measures*>(8, &healthy));
  Measures window = with_levels(Eigen::Array4d(-12, 5, -24, -36));  // rises -2, 25, 6, 4
  for (std::size_t fault_type = 0; fault_type < 3; ++fault_type) {
    for (std::size_t n = 0; n < 4; ++n) {
      window.heights.at(fault_type).at(n) =
          10 * static_cast<double>(fault_type) + static_cast<double>(n);
    }
  }
  window.log_kurtosis = 1.5;
  const Symptoms symptoms = symptoms_of(window, baseline, 3);
  const Symptoms expected{0,  1,  2,  3,   10, 11,       12, 13,         20,
                          21, 22, 23, 1.5, 20, 35.0 / 3, -2, std::log(3)};
  for (std::size_t i = 0; i < number_of_symptoms; ++i) {
    EXPECT_NEAR(symptoms.at(i), expected.at(i), 1e-12) << i;
  }
}

TEST(Symptoms, AreClipped) {
  const Measures healthy = with_levels(Eigen::Array4d(0, 0, 0, 0));
  const Baseline baseline(std::vector<const Measures*>(8, &healthy));
  const Symptoms quiet = symptoms_of(with_levels(Eigen::Array4d::Constant(-50)), baseline, 0.5);
  EXPECT_EQ(quiet[13], -3);
  EXPECT_EQ(quiet[14], -3);
  EXPECT_EQ(quiet[15], -20);
  EXPECT_NEAR(quiet[16], std::log(0.5), 1e-12);
  const Symptoms high_level = symptoms_of(with_levels(Eigen::Array4d::Constant(50)), baseline, 100);
  EXPECT_EQ(high_level[13], 20);
  EXPECT_EQ(high_level[14], 20);
  EXPECT_EQ(high_level[15], 3);
  EXPECT_NEAR(high_level[16], std::log(6), 1e-12);
}

}  // namespace
}  // namespace piae::symptoms
