#pragma once

#include <omp.h>

#include <string>

#include "base/random.hpp"
#include "embedding/points.hpp"

namespace piae::embedding {

/// Returns normally distributed points around 0.
inline Points cloud(Eigen::Index count, Eigen::Index dimensions, const std::string& name) {
  Stream stream(name);
  Points points(count, dimensions);
  for (double& coordinate : points.reshaped<Eigen::RowMajor>()) coordinate = stream.normal(0, 1);
  return points;
}

/// Returns three interleaved clouds: row i belongs to cloud i % 3. Their centres are `distance`
/// standard deviations from 0, along the first three coordinates.
inline Points three_clouds(Eigen::Index count, Eigen::Index dimensions, double distance,
                           const std::string& name) {
  Points points = cloud(count, dimensions, name);
  for (Eigen::Index i = 0; i < count; ++i) points(i, i % 3) += distance;
  return points;
}

/// Sets the number of OpenMP threads during its lifetime.
class Threads {
 public:
  explicit Threads(int count) : before_(omp_get_max_threads()) { omp_set_num_threads(count); }
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;
  ~Threads() { omp_set_num_threads(before_); }

 private:
  int before_;
};

}  // namespace piae::embedding
