#include "diagnosis/adversary.hpp"

#include <cmath>
#include <string>
#include <utility>

namespace piae::diagnosis {

double reversal_at(double progress) { return 2 / (1 + std::exp(-10 * progress)) - 1; }

Adversary::Adversary(Adversity settings, std::size_t length, std::int64_t classes,
                     std::int64_t most_labelled, std::int64_t steps, double learning_rate,
                     const Stream& initial)
    : unlabelled_(std::move(settings.unlabelled)),
      stream_(std::move(settings.stream)),
      length_(length),
      steps_(steps),
      learning_rate_(learning_rate),
      domains_(settings.adaptation, classes, 2 * most_labelled, initial) {}

const float* Adversary::next() {
  if (order_.empty()) {
    order_ = stream_.child("unlabelled" + std::to_string(++pass_))
                 .permutation(unlabelled_.size() / length_);
  }
  const std::size_t i = order_.back();
  order_.pop_back();
  return unlabelled_.data() + i * length_;
}

std::span<const float* const> Adversary::joined(std::span<const float* const> labelled) {
  windows_.assign(labelled.begin(), labelled.end());
  for (std::size_t i = 0; i < labelled.size(); ++i) windows_.push_back(next());
  return windows_;
}

std::span<const float> Adversary::gradient(WdcnnNetwork<float>& network) {
  const std::int64_t windows = std::ssize(windows_);
  gradient_.assign(static_cast<std::size_t>(windows * network.hidden_row()), 0.0F);
  const double progress = static_cast<double>(done_++) / static_cast<double>(steps_);
  (void)domains_.step({.hidden = {network.hidden(), network.hidden_row()},
                       .logits = {network.logits(), network.logits_row()},
                       .windows = windows,
                       .labelled = windows / 2},
                      learning_rate_, reversal_at(progress),
                      {gradient_.data(), network.hidden_row()});
  return gradient_;
}

}  // namespace piae::diagnosis
