#include "diagnosis/folds.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "base/error.hpp"
#include "diagnosis/training_set.hpp"
#include "spectra/left_out.hpp"
#include "symptoms/baseline.hpp"

namespace piae::diagnosis {

namespace {

using signal::WindowSet;

constexpr auto number_of_folds = static_cast<std::size_t>(Folds::count);

/// Returns [n] the fold of each window; the windows of each class are dealt out in turn.
std::vector<std::int32_t> dealt_out(const WindowSet& windows) {
  std::vector<std::int32_t> folds(windows.size());
  for (const Label label : windows.info.labels()) {
    std::int32_t next = 0;
    for (const std::size_t i : windows.indices_of(label)) folds[i] = next++ % Folds::count;
  }
  return folds;
}

void add(Folds& folds, std::int32_t tested, std::vector<bool> left_out) {
  folds.tested.push_back(tested);
  folds.left_out.push_back(std::move(left_out));
}

void add(Folds& folds, const std::vector<std::int32_t>& tested) {
  for (const std::int32_t fold : tested) {
    std::vector<bool> left_out(number_of_folds);
    left_out[static_cast<std::size_t>(fold)] = true;
    add(folds, fold, std::move(left_out));
  }
}

std::size_t fold_of_parent(const std::vector<std::int32_t>& of_known, std::size_t parent) {
  if (parent < of_known.size()) return static_cast<std::size_t>(of_known[parent]);
  throw Error(Exit::bad_input,
              fmt::format("--generated: a window was made from known window {}, but --known holds "
                          "{} windows; give files of one split",
                          parent, of_known.size()));
}

void add_generated(Folds& folds, const WindowSet& generated, std::size_t per_class,
                   const std::vector<std::int32_t>& of_known) {
  const std::vector<std::int32_t> dealt = dealt_out(generated);
  for (const std::size_t i : first_of_each_fault(generated, per_class)) {
    if (of_known.empty()) {
      add(folds, {dealt[i]});
      continue;
    }
    std::vector<bool> left_out(number_of_folds);
    if (!generated.parents.empty()) {
      for (const std::int32_t parent : generated.parents[i]) {
        left_out[fold_of_parent(of_known, static_cast<std::size_t>(parent))] = true;
      }
    }
    add(folds, Folds::none, std::move(left_out));
  }
}

/// True if each class has windows to train on, whichever fold is left out, and has windows to
/// predict.
bool is_possible(const WindowSet& training, const Folds& folds) {
  const std::size_t classes = training.info.classes.size();
  const Label healthy = training.info.healthy_label();
  std::vector<bool> tested(classes);
  for (std::size_t i = 0; i < training.size(); ++i) {
    if (folds.tested[i] != Folds::none) tested[index_of(training.labels[i])] = true;
  }
  if (std::ranges::count(tested, false) > 0) return false;
  for (std::size_t fold = 0; fold < number_of_folds; ++fold) {
    std::vector<std::size_t> learned(classes);
    for (std::size_t i = 0; i < training.size(); ++i) {
      if (!folds.left_out[i][fold]) ++learned[index_of(training.labels[i])];
    }
    if (std::ranges::count(learned, 0U) > 0) return false;
    if (learned[index_of(healthy)] < symptoms::fewest_healthy) return false;
  }
  return true;
}

}  // namespace

std::vector<std::int32_t> blocks_of_time(const WindowSet& normal) {
  const std::vector<std::size_t> order = signal::in_time_order(normal);
  std::vector<std::int32_t> folds(order.size());
  for (std::size_t place = 0; place < order.size(); ++place) {
    folds[order[place]] =
        static_cast<std::int32_t>(spectra::block_of(place, order.size(), number_of_folds));
  }
  return folds;
}

Folds folds_of(const WindowSet& training, const Lessons& lessons) {
  Folds folds;
  add(folds, blocks_of_time(lessons.normal));
  const std::vector<std::int32_t> of_known = dealt_out(lessons.known);
  add(folds, of_known);
  if (lessons.generated != nullptr) {
    add_generated(folds, *lessons.generated, static_cast<std::size_t>(lessons.generated_per_class),
                  of_known);
  }
  folds.possible = is_possible(training, folds);
  return folds;
}

}  // namespace piae::diagnosis
