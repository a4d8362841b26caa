#include "diagnosis/episodes.hpp"

#include <Eigen/Core>
#include <algorithm>

namespace piae::diagnosis {

namespace {

using Eigen::Index;

Eigen::ArrayXd counts_of(const std::vector<Label>& labels, std::int64_t classes) {
  Eigen::ArrayXd counts = Eigen::ArrayXd::Zero(classes);
  for (const Label label : labels) ++counts[label];
  return counts;
}

}  // namespace

Episode draw_episode(const std::vector<std::vector<std::size_t>>& windows_of, EpisodeSize size,
                     Stream& random) {
  Episode episode;
  for (std::size_t c = 0; c < windows_of.size(); ++c) {
    const std::vector<std::size_t>& own = windows_of[c];
    const std::size_t queries = std::min(size.queries, own.size() / 2);
    const std::size_t shots = std::min(size.shots, own.size() - queries);
    const std::vector<std::size_t> order = random.permutation(own.size());
    for (std::size_t i = 0; i < shots + queries; ++i) {
      (i < shots ? episode.support : episode.queries).push_back(own[order[i]]);
      (i < shots ? episode.support_labels : episode.query_labels).push_back(static_cast<Label>(c));
    }
  }
  return episode;
}

Embeddings distance_logits(const Embeddings& embeddings, const Embeddings& prototypes) {
  Embeddings logits(embeddings.rows(), prototypes.rows());
  for (Index i = 0; i < embeddings.rows(); ++i) {
    logits.row(i) =
        -(prototypes.rowwise() - embeddings.row(i)).square().rowwise().sum().transpose();
  }
  return logits;
}

Embeddings mean_embeddings(const Embeddings& embeddings, const std::vector<Label>& labels,
                           std::int64_t classes) {
  Embeddings means = Embeddings::Zero(classes, embeddings.cols());
  for (Index i = 0; i < embeddings.rows(); ++i) {
    means.row(labels[static_cast<std::size_t>(i)]) += embeddings.row(i);
  }
  means.colwise() /= counts_of(labels, classes);
  return means;
}

BatchOutcome episode_loss(const Episode& episode, std::int64_t classes,
                          const Embeddings& embeddings, Embeddings& gradient) {
  const Index shots = std::ssize(episode.support);
  const Embeddings queries = embeddings.bottomRows(embeddings.rows() - shots);
  const Embeddings prototypes =
      mean_embeddings(embeddings.topRows(shots), episode.support_labels, classes);
  const Embeddings logits = distance_logits(queries, prototypes);
  Embeddings by_logit(logits.rows(), classes);
  const BatchOutcome outcome =
      cross_entropy(classes, classes, episode.query_labels, logits.data(), by_logit.data());
  // The derivative of -|q - p|^2 by q is 2 (p - q), and by p its negative. The gradients by the
  // logits of a query sum to 0, so the term with q vanishes for queries.
  const Eigen::MatrixXd by_query = 2 * by_logit.matrix() * prototypes.matrix();
  Embeddings by_prototype = 2 * (by_logit.matrix().transpose() * queries.matrix()).array();
  by_prototype -= 2 * (prototypes.colwise() * by_logit.colwise().sum().transpose());
  const Eigen::ArrayXd counts = counts_of(episode.support_labels, classes);
  gradient.resize(embeddings.rows(), embeddings.cols());
  for (Index i = 0; i < shots; ++i) {
    const Label label = episode.support_labels[static_cast<std::size_t>(i)];
    gradient.row(i) = by_prototype.row(label) / counts[label];
  }
  gradient.bottomRows(queries.rows()) = by_query;
  return outcome;
}

}  // namespace piae::diagnosis
