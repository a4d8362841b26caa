#pragma once

#include <cstdint>
#include <vector>

namespace piae::diagnosis {

/// Where the batches of an epoch over n windows begin, and n at the end: {0, 32, 64, 97}. A last
/// batch of one window, which batch normalisation cannot use, is joined to the one before it.
/// n and batch are at least 2.
std::vector<std::int64_t> batch_bounds(std::int64_t n, std::int64_t batch);

}  // namespace piae::diagnosis
