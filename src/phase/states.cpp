#include "phase/states.hpp"

#include <cmath>

namespace piae::phase {

namespace {

struct Moments {
  double mean = 0;
  double spread = 1;
};

Moments moments_of_log(const std::vector<double>& values) {
  Moments moments;
  if (values.empty()) return moments;
  const auto n = static_cast<double>(values.size());
  for (const double value : values) moments.mean += std::log(value) / n;
  double variance = 0;
  for (const double value : values) variance += std::pow(std::log(value) - moments.mean, 2) / n;
  if (variance > 0) moments.spread = std::sqrt(variance);
  return moments;
}

}  // namespace

StateScale::StateScale(const std::vector<twin::TwinPoint>& points, std::span<const Label> labels,
                       std::size_t classes) {
  for (Label label = 0; index_of(label) < classes; ++label) {
    std::vector<double> k;
    std::vector<double> c;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (labels[i] != label) continue;
      k.push_back(points[i].k);
      c.push_back(points[i].c);
    }
    const Moments of_k = moments_of_log(k);
    const Moments of_c = moments_of_log(c);
    classes_.push_back(
        {.mean = {.k = of_k.mean, .c = of_c.mean}, .spread = {.k = of_k.spread, .c = of_c.spread}});
  }
}

twin::TwinPoint StateScale::standardised(const twin::TwinPoint& point, Label label) const {
  const Class& own = classes_.at(index_of(label));
  return {.k = (std::log(point.k) - own.mean.k) / own.spread.k,
          .c = (std::log(point.c) - own.mean.c) / own.spread.c};
}

std::vector<twin::TwinPoint> StateScale::standardised(const std::vector<twin::TwinPoint>& points,
                                                      std::span<const Label> labels) const {
  std::vector<twin::TwinPoint> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.push_back(standardised(points[i], labels[i]));
  }
  return result;
}

}  // namespace piae::phase
