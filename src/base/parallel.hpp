#pragma once

#include <cstddef>
#include <functional>

namespace piae {

/// Calls body(0), ..., body(count - 1) on the threads of OpenMP, in no particular order. A body
/// must write only to what belongs to its index; then the result does not depend on the number of
/// threads. Where bodies throw, the exception of the lowest index is thrown when all have ended.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

/// The same where one call does several things at once. There are `sets` sets of `of_each` things,
/// numbered from 0 through all sets. Each set is cut into parts of at most `most` things, and
/// body(first, count) is called for each part.
void parallel_for_parts(std::size_t sets, std::size_t of_each, std::size_t most,
                        const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace piae
