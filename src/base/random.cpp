#include "base/random.hpp"

#include <boost/random/beta_distribution.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <cstdint>
#include <numeric>
#include <utility>

#include "base/sha256.hpp"

namespace piae {

namespace {

std::uint64_t seed_of(std::string_view name) {
  const std::string digest = Sha256().update(name).finish();
  std::uint64_t seed = 0;
  for (std::size_t i = 0; i < 8; ++i) seed = seed << 8U | static_cast<unsigned char>(digest[i]);
  return seed;
}

}  // namespace

Stream::Stream(std::string name) : name_(std::move(name)), engine_(seed_of(name_)) {}

Stream Stream::child(std::string_view name) const {
  return Stream(name_ + "/" + std::string(name));
}

double Stream::uniform(double low, double high) {
  return boost::random::uniform_real_distribution<double>(low, high)(engine_);
}

double Stream::normal(double mean, double standard_deviation) {
  return boost::random::normal_distribution<double>(mean, standard_deviation)(engine_);
}

double Stream::beta(double alpha, double beta) {
  return boost::random::beta_distribution<double>(alpha, beta)(engine_);
}

std::size_t Stream::below(std::size_t bound) {
  return boost::random::uniform_int_distribution<std::size_t>(0, bound - 1)(engine_);
}

std::vector<std::size_t> Stream::permutation(std::size_t size) {
  std::vector<std::size_t> order(size);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = size; i > 1; --i) std::swap(order[i - 1], order[below(i)]);  // Fisher-Yates
  return order;
}

}  // namespace piae
