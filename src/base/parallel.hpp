#pragma once

#include <cstddef>
#include <functional>

namespace piae {

/// Calls body(0), ..., body(count - 1), by OpenMP and in no particular order. A body writes only to
/// what belongs to its index, so that the result does not depend on the number of threads. What a
/// body throws is thrown here once all have ended: that of the lowest index, whoever came first.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

/// The same for what is done several at once: `sets` of `of_each` things, numbered through, are cut
/// into parts of `most` or fewer, none with things of two sets, and body(first, count) called for
/// each part.
void parallel_for_parts(std::size_t sets, std::size_t of_each, std::size_t most,
                        const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace piae
