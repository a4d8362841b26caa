#include "diagnosis/keep.hpp"

#include <span>
#include <string>
#include <utility>

#include "base/sha256.hpp"
#include "diagnosis/learn.hpp"
#include "diagnosis/left_out.hpp"
#include "scoring/temperature.hpp"

namespace piae::diagnosis {

namespace {

using signal::WindowSet;

Calibration calibrated(const Classifier& classifier, const WindowSet& training,
                       const Lessons& lessons, const Relearn& relearn) {
  const Folds folds = folds_of(training, lessons);
  if (!folds.possible) return {};
  const LeftOut left_out = judge_left_out(
      training, folds, [&](const WindowSet& normal, const WindowSet& kept, std::int32_t fold) {
        const Stream own = relearn.stream.child("left-out" + std::to_string(fold));
        return learn(classifier, normal, kept, relearn.settings, own, relearn.epoch_done).trained;
      });
  return {.temperature = scoring::best_temperature(left_out.logits, left_out.labels,
                                                   training.info.classes.size()),
          .windows = std::ssize(left_out.labels)};
}

/// True if faults are known in exactly the tested conditions.
bool known_where_tested(const WindowSet& known) {
  return known.size() > 0 && known.info.known_conditions() == known.info.tested_conditions();
}

std::optional<Novelty> novelty_by(const WindowSet& training, const Lessons& lessons) {
  if (!known_where_tested(lessons.known)) return std::nullopt;
  const std::size_t real = lessons.normal.size() + lessons.known.size();
  WindowSet reference;
  reference.info = training.info;
  reference.length = training.length;
  for (std::size_t i = 0; i < real; ++i) reference.append(training, i);
  std::vector<std::int32_t> groups = blocks_of_time(lessons.normal);
  while (groups.size() < real) {  // each known fault window is a group of its own
    groups.push_back(Folds::count + static_cast<std::int32_t>(groups.size()));
  }
  return Novelty(reference, std::move(groups));
}

std::string digest_of(const WindowSet& training) {
  return Sha256()
      .update(std::as_bytes(std::span(training.samples)))
      .update(std::as_bytes(std::span(training.labels)))
      .finish_hex();
}

}  // namespace

std::int64_t trainings_to_keep(const WindowSet& training, const Lessons& lessons) {
  return folds_of(training, lessons).possible ? Folds::count : 0;
}

KeptClassifier keep(const Classifier& classifier, std::unique_ptr<Trained> trained,
                    const WindowSet& training, const Lessons& lessons, const Relearn& relearn,
                    ClassifierOrigin origin) {
  origin.training_windows = std::ssize(training.labels);
  origin.training_digest = digest_of(training);
  return {training.info,
          training.length,
          classifier,
          std::move(trained),
          calibrated(classifier, training, lessons, relearn),
          novelty_by(training, lessons),
          std::move(origin)};
}

}  // namespace piae::diagnosis
