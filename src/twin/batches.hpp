#pragma once

#include <cstddef>
#include <vector>

#include "base/label.hpp"
#include "base/random.hpp"
#include "twin/options.hpp"

namespace piae::twin {

/// The batches of one epoch: the indices of the known windows, each once, in random order, at most
/// `size` in a batch. What does not fill a batch makes a smaller one. In batches of classes no
/// class is parted that fits into one, and one that is parted has its batches for itself.
std::vector<std::vector<std::size_t>> batches_of_an_epoch(const std::vector<Label>& labels,
                                                          Batches kind, std::size_t size,
                                                          Stream& shuffle);

}  // namespace piae::twin
