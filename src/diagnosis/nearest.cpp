#include "diagnosis/nearest.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <limits>

#include "base/error.hpp"
#include "diagnosis/band_powers.hpp"

namespace piae::diagnosis {

namespace {

using Eigen::Index;

/// Logit of a class without windows. It is finite because stored numbers must be finite.
constexpr float farthest_logit = -1e6F;

}  // namespace

Nearest::Nearest(const signal::WindowSet& training)
    : length_(training.length),
      classes_(training.info.classes.size()),
      labels_(training.labels),
      training_(band_powers(training)) {}

Nearest::Nearest(const artefact::Reader& reader, const signal::DatasetInfo& info,
                 std::size_t length)
    : length_(length),
      classes_(info.classes.size()),
      labels_(read_labels(reader, learned, info)),
      training_(read_bands(reader, learned, labels_.size())) {}

Outputs Nearest::outputs(const signal::WindowSet& windows, const std::string& what) {
  if (windows.length != length_) {
    throw Error(Exit::bad_input,
                fmt::format("{}: windows of {} samples, but the training windows have {}; both "
                            "must be the same: give files of one split",
                            what, windows.length, length_));
  }
  const BandPowers window_bands = band_powers(windows);
  Outputs all;
  all.scores.assign(windows.size() * classes_, 0);
  all.logits.assign(windows.size() * classes_, farthest_logit);
  for (Index begin = 0; begin < window_bands.rows(); begin += Neighbours::at_a_time) {
    const Index count = std::min(Neighbours::at_a_time, window_bands.rows() - begin);
    const Eigen::MatrixXd squares =
        training_.squared_distances(window_bands.middleRows(begin, count));
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
                      const Stream& /*stream*/, const EpochDone& /*epoch_done*/) {
  return {.trained = std::make_unique<Nearest>(training), .training = {}};
}

std::unique_ptr<Trained> read_nearest(const artefact::Reader& reader,
                                      const signal::DatasetInfo& info, std::size_t length) {
  return std::make_unique<Nearest>(reader, info, length);
}

}  // namespace piae::diagnosis
