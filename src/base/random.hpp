#pragma once

#include <boost/random/mersenne_twister.hpp>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace piae {

/// A random stream that is derived from its name alone, such as "cwru/seed3/split/IR007": the same
/// name gives the same numbers whatever ran before it, beside it, or with how many threads.
/// Boost.Random is used because its distributions are the same on every platform; those of the
/// standard library are not.
class Stream {
 public:
  explicit Stream(std::string name);

  /// The stream called "<this name>/<name>". What is drawn from one does not change the other.
  [[nodiscard]] Stream child(std::string_view name) const;
  [[nodiscard]] const std::string& name() const { return name_; }

  double uniform(double low, double high);  ///< in [low, high)
  double normal(double mean, double standard_deviation);
  std::size_t below(std::size_t bound);                    ///< in {0, ..., bound - 1}; bound > 0
  std::vector<std::size_t> permutation(std::size_t size);  ///< of {0, ..., size - 1}

 private:
  std::string name_;
  boost::random::mt19937_64 engine_;
};

}  // namespace piae
