#pragma once

#include <cstddef>
#include <vector>

#include "base/label.hpp"
#include "base/random.hpp"
#include "twin/options.hpp"

namespace piae::twin {

/// Returns the batches of one epoch: the indices of the known windows, each once, in random order,
/// at most `size` per batch. The last windows may make a smaller batch. With Batches::of_one_class,
/// a class that fits into one batch is never split, and a split class does not share its batches.
std::vector<std::vector<std::size_t>> batches_of_an_epoch(const std::vector<Label>& labels,
                                                          Batches kind, std::size_t size,
                                                          Stream& shuffle);

}  // namespace piae::twin
