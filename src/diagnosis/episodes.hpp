#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/label.hpp"
#include "base/random.hpp"
#include "diagnosis/cross_entropy.hpp"
#include "nets/row_array.hpp"

namespace piae::diagnosis {

/// Number of windows that an episode draws from each class.
struct EpisodeSize {
  std::size_t shots = 5;    ///< windows whose mean embedding is the prototype
  std::size_t queries = 5;  ///< windows that are classified by the prototypes
};

/// Windows of one episode (Snell et al. 2017), indices into the training set; no window is in both
/// lists.
struct Episode {
  std::vector<std::size_t> support;
  std::vector<Label> support_labels;
  std::vector<std::size_t> queries;
  std::vector<Label> query_labels;
};

/// Draws an episode with all classes. `windows_of` holds the indices of each class's windows, at
/// least one. A class with fewer than shots + queries windows gives half of them, rounded down, as
/// queries and the others as support: five windows give two queries, and one window none.
Episode draw_episode(const std::vector<std::vector<std::size_t>>& windows_of, EpisodeSize size,
                     Stream& random);

/// One row for each window or class.
using Embeddings = nets::RowArray<double>;

/// Returns [n, classes] minus the squared Euclidean distance of each embedding to each prototype:
/// the logits of a network of prototypes.
Embeddings distance_logits(const Embeddings& embeddings, const Embeddings& prototypes);

/// Returns [classes] the mean embedding of each class, which must have one.
Embeddings mean_embeddings(const Embeddings& embeddings, const std::vector<Label>& labels,
                           std::int64_t classes);

/// Returns the cross-entropy of the queries, summed, and writes the gradient of its mean by each
/// embedding. `embeddings` has a row for each support window, then one for each query.
BatchOutcome episode_loss(const Episode& episode, std::int64_t classes,
                          const Embeddings& embeddings, Embeddings& gradient);

}  // namespace piae::diagnosis
