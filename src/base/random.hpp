#pragma once

#include <boost/random/mersenne_twister.hpp>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace piae {

/// A random stream that depends on its name only, such as "cwru/seed3/split/IR007": a name gives
/// the same numbers for any order of work and any number of threads. Boost.Random has the same
/// distributions on every platform; the standard library does not.
class Stream {
 public:
  explicit Stream(std::string name);

  /// Returns the stream "<this name>/<name>". Drawing from one stream does not change the other.
  [[nodiscard]] Stream child(std::string_view name) const;
  [[nodiscard]] const std::string& name() const { return name_; }

  double uniform(double low, double high);  ///< in [low, high)
  double normal(double mean, double standard_deviation);
  double beta(double alpha, double beta);                  ///< in [0, 1]; both shapes at least 0.05
  std::size_t below(std::size_t bound);                    ///< in {0, ..., bound - 1}; bound > 0
  std::vector<std::size_t> permutation(std::size_t size);  ///< of {0, ..., size - 1}

 private:
  std::string name_;
  boost::random::mt19937_64 engine_;
};

}  // namespace piae
