#include "symptoms/symptoms.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace piae::symptoms {

namespace {

constexpr Eigen::Index highest_bands = 3;
constexpr double most_risen_db = 20;
constexpr double least_risen_db = 3;
constexpr double most_novel = 6;

}  // namespace

Symptoms symptoms_of(const Measures& window, const Baseline& baseline, double novelty) {
  Symptoms symptoms{};
  auto* next = symptoms.begin();
  for (const auto& heights : window.heights) next = std::ranges::copy(heights, next).out;
  *next++ = window.log_kurtosis;

  Eigen::ArrayXd rises_db = baseline.rise_db(window);
  std::ranges::sort(rises_db, std::greater());
  const double three_db = rises_db.head(std::min(highest_bands, rises_db.size())).mean();
  const auto last = rises_db.size() - 1;
  *next++ = std::clamp(rises_db[0], -least_risen_db, most_risen_db);
  *next++ = std::clamp(three_db, -least_risen_db, most_risen_db);
  *next++ = std::clamp(rises_db[last], -most_risen_db, least_risen_db);
  *next = std::log(std::min(novelty, most_novel));
  return symptoms;
}

}  // namespace piae::symptoms
