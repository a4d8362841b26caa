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

StateScale::StateScale(const std::vector<twin::TwinPoint>& points,
                       std::span<const std::int32_t> labels, std::size_t classes) {
  for (std::size_t label = 0; label < classes; ++label) {
    std::vector<double> k;
    std::vector<double> c;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (static_cast<std::size_t>(labels[i]) != label) continue;
      k.push_back(points[i].k);
      c.push_back(points[i].c);
    }
    const Moments of_k = moments_of_log(k);
    const Moments of_c = moments_of_log(c);
    classes_.push_back({{of_k.mean, of_c.mean}, {of_k.spread, of_c.spread}});
  }
}

twin::TwinPoint StateScale::standardised(const twin::TwinPoint& point, std::size_t label) const {
  const Class& own = classes_.at(label);
  return {(std::log(point.k) - own.mean.k) / own.spread.k,
          (std::log(point.c) - own.mean.c) / own.spread.c};
}

std::vector<twin::TwinPoint> StateScale::standardised(const std::vector<twin::TwinPoint>& points,
                                                      std::span<const std::int32_t> labels) const {
  std::vector<twin::TwinPoint> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.push_back(standardised(points[i], static_cast<std::size_t>(labels[i])));
  }
  return result;
}

}  // namespace piae::phase
