#include "base/parallel.hpp"

#include <cstdint>
#include <exception>
#include <vector>

namespace piae {

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
  std::vector<std::exception_ptr> failures(count);
  const auto end = static_cast<std::int64_t>(count);
#pragma omp parallel for schedule(dynamic)
  for (std::int64_t i = 0; i < end; ++i) {
    try {
      body(static_cast<std::size_t>(i));
    } catch (...) {  // must not leave the parallel loop
      failures[static_cast<std::size_t>(i)] = std::current_exception();
    }
  }
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace piae
