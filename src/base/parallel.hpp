#pragma once

#include <cstddef>
#include <functional>

namespace piae {

/// Calls body(0), ..., body(count - 1), by OpenMP and in no particular order. A body writes only to
/// what belongs to its index, so that the result does not depend on the number of threads. What a
/// body throws is thrown here once all have ended: that of the lowest index, whoever came first.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace piae
