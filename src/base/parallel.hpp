#pragma once

#include <cstddef>
#include <functional>

namespace piae {

/// Calls body(0), ..., body(count - 1) on the threads of OpenMP, in any order. Each call must write
/// only to the data of its index, so that the result does not depend on the number of threads. If
/// calls throw, rethrows the exception of the lowest index after all calls have ended.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

/// Calls body(first, count) for parts of `sets` sets of `of_each` items, which are numbered from 0
/// through all sets. Each set is cut into parts of at most `most` items.
void parallel_for_parts(std::size_t sets, std::size_t of_each, std::size_t most,
                        const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace piae
