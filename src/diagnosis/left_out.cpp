#include "diagnosis/left_out.hpp"

namespace piae::diagnosis {

namespace {

using signal::WindowSet;

/// Returns the windows whose index satisfies `is_chosen`.
template <class Chosen>
WindowSet chosen_of(const WindowSet& all, const Chosen& is_chosen) {
  WindowSet chosen;
  chosen.info = all.info;
  chosen.length = all.length;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (is_chosen(i)) chosen.append(all, i);
  }
  return chosen;
}

}  // namespace

LeftOut judge_left_out(const WindowSet& training, const Folds& folds, const TrainFold& train) {
  const Label healthy = training.info.healthy_label();
  LeftOut all;
  for (std::int32_t fold = 0; fold < Folds::count; ++fold) {
    const auto is_kept = [&](std::size_t i) {
      return !folds.left_out[i][static_cast<std::size_t>(fold)];
    };
    const WindowSet kept = chosen_of(training, is_kept);
    const WindowSet normal =
        chosen_of(kept, [&](std::size_t i) { return kept.labels[i] == healthy; });
    const WindowSet tested =
        chosen_of(training, [&](std::size_t i) { return folds.tested[i] == fold; });
    if (tested.size() == 0) continue;
    const Outputs outputs = train(normal, kept, fold)->outputs(tested, "a left-out window");
    all.logits.insert(all.logits.end(), outputs.logits.begin(), outputs.logits.end());
    all.labels.insert(all.labels.end(), tested.labels.begin(), tested.labels.end());
  }
  return all;
}

}  // namespace piae::diagnosis
