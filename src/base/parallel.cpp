#include "base/parallel.hpp"

#include <algorithm>
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
    } catch (...) {  // exceptions must not leave the parallel loop
      failures[static_cast<std::size_t>(i)] = std::current_exception();
    }
  }
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

void parallel_for_parts(std::size_t sets, std::size_t of_each, std::size_t most,
                        const std::function<void(std::size_t, std::size_t)>& body) {
  const std::size_t parts = (of_each + most - 1) / most;
  parallel_for(sets * parts, [&](std::size_t i) {
    const std::size_t of_set = i % parts * most;
    body(i / parts * of_each + of_set, std::min(most, of_each - of_set));
  });
}

}  // namespace piae
