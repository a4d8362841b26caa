#pragma once

#include <cstdint>
#include <vector>

namespace piae::diagnosis {

/// Returns the first window of each batch of an epoch over n windows, then n: {0, 32, 64, 97} for n
/// = 97 and batches of 32. Batch normalisation cannot use a batch of one window, so a single last
/// window joins the batch before it. n and batch must be at least 2.
std::vector<std::int64_t> batch_bounds(std::int64_t n, std::int64_t batch);

}  // namespace piae::diagnosis
