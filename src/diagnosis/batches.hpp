#pragma once

#include <cstdint>
#include <vector>

namespace piae::diagnosis {

/// Where the batches of an epoch over n windows begin, and n at the end: {0, 32, 64, 97} for n = 97
/// and batches of 32. Batch normalisation cannot use a batch of one window, so a last batch of one
/// is joined to the batch before it. n and batch must be at least 2.
std::vector<std::int64_t> batch_bounds(std::int64_t n, std::int64_t batch);

}  // namespace piae::diagnosis
