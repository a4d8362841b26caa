#include "diagnosis/nearest.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <limits>

#include "base/error.hpp"
#include "diagnosis/stored_bands.hpp"

namespace piae::diagnosis {

namespace {

using Eigen::Index;

/// For a class of which there is no window. Not infinite, since what is stored is finite.
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

WdcnnOutputs Nearest::outputs(const signal::WindowSet& windows, const std::string& what) {
  if (windows.length != length_) {
    throw Error(Exit::bad_input,
                fmt::format("{}: windows of {} samples, but those that are compared with have {}; "
                            "both must be the same",
                            what, windows.length, length_));
  }
  const Eigen::MatrixXd squares = training_.squared_distances(band_powers(windows));
  WdcnnOutputs all;
  all.scores.assign(windows.size() * classes_, 0);
  all.logits.assign(windows.size() * classes_, farthest_logit);
  for (Index i = 0; i < squares.cols(); ++i) {
    float* const logits = all.logits.data() + static_cast<std::size_t>(i) * classes_;
    Index nearest = 0;
    squares.col(i).minCoeff(&nearest);
    for (Index j = 0; j < squares.rows(); ++j) {
      float& logit = logits[index_of(labels_[static_cast<std::size_t>(j)])];
      logit = std::max(logit, static_cast<float>(-squares(j, i) / 2));
    }
    const Label named = labels_[static_cast<std::size_t>(nearest)];
    all.scores[static_cast<std::size_t>(i) * classes_ + index_of(named)] = 1;
  }
  return all;
}

void Nearest::write(artefact::Writer& writer) const {
  write_bands(writer, learned, training_.known(), labels_);
}

}  // namespace piae::diagnosis
