#include "diagnosis/nearest.hpp"

#include <algorithm>
#include <limits>

#include "diagnosis/standardise.hpp"

namespace piae::diagnosis {

namespace {

using Eigen::Index;

/// Logit of a class without windows. It is finite because stored numbers must be finite.
constexpr float farthest_logit = -1e6F;

}  // namespace

FeatureRows band_power_features(const signal::WindowSet& windows, const std::string& /*what*/) {
  return band_powers(windows);
}

Nearest::Nearest(const signal::WindowSet& training, const WindowFeatures& features)
    : features_(features),
      length_(training.length),
      classes_(training.info.classes.size()),
      labels_(training.labels),
      training_(features.of(training, "training set")) {}

Nearest::Nearest(const artefact::Reader& reader, const signal::DatasetInfo& info,
                 std::size_t length, const WindowFeatures& features)
    : features_(features),
      length_(length),
      classes_(info.classes.size()),
      labels_(read_labels(reader, learned, info)),
      training_(read_bands(reader, learned, labels_.size(), features.columns)) {}

Outputs Nearest::outputs(const signal::WindowSet& windows, const std::string& what) {
  require_length(windows, length_, what);
  const FeatureRows rows = features_.of(windows, what);
  Outputs all;
  all.scores.assign(windows.size() * classes_, 0);
  all.logits.assign(windows.size() * classes_, farthest_logit);
  for (Index begin = 0; begin < rows.rows(); begin += Neighbours::at_a_time) {
    const Index count = std::min(Neighbours::at_a_time, rows.rows() - begin);
    const Eigen::MatrixXd squares = training_.squared_distances(rows.middleRows(begin, count));
    for (Index i = 0; i < count; ++i) {
      predict(squares.col(i), static_cast<std::size_t>(begin + i), all);
    }
  }
  return all;
}

void Nearest::predict(const Eigen::VectorXd& squares, std::size_t window, Outputs& all) const {
  float* const logits = all.logits.data() + window * classes_;
  Index nearest = 0;
  squares.minCoeff(&nearest);
  for (Index j = 0; j < squares.size(); ++j) {
    float& logit = logits[index_of(labels_[static_cast<std::size_t>(j)])];
    logit = std::max(logit, static_cast<float>(-squares[j] / 2));
  }
  const Label named = labels_[static_cast<std::size_t>(nearest)];
  all.scores[window * classes_ + index_of(named)] = 1;
}

void Nearest::write(artefact::Writer& writer) const {
  write_bands(writer, learned, training_.known(), labels_);
}

Learned learn_nearest(const signal::WindowSet& /*normal*/, const signal::WindowSet& training,
                      double /*prewhitening*/, const Stream& /*stream*/,
                      const EpochDone& /*epoch_done*/) {
  return {.trained = std::make_unique<Nearest>(training), .training = {}};
}

std::unique_ptr<Trained> read_nearest(const artefact::Reader& reader,
                                      const signal::DatasetInfo& info, std::size_t length) {
  return std::make_unique<Nearest>(reader, info, length);
}

}  // namespace piae::diagnosis
