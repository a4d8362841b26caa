#include "report/demo_answers.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <optional>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "report/accuracies.hpp"
#include "report/labels.hpp"
#include "text/wrap.hpp"

namespace piae::report {

namespace {

std::string percent(const AccuracyRow& row) { return fmt::format("{:.0f} %", row.summary.mean); }

/// Returns a row for each method, ratio and classifier.
std::vector<AccuracyRow> rows_of_cells(const std::vector<run::Diagnosis>& cells) {
  std::vector<std::vector<run::Diagnosis>> groups;
  for (const run::Diagnosis& cell : cells) {
    const auto same = std::ranges::find_if(groups, [&](const auto& group) {
      const run::Diagnosis& first = group.front();
      return first.method == cell.method && first.ratio == cell.ratio &&
             first.classifier == cell.classifier;
    });
    if (same == groups.end()) {
      groups.push_back({cell});
    } else {
      same->push_back(cell);
    }
  }
  std::vector<AccuracyRow> rows;
  rows.reserve(groups.size());
  for (const auto& group : groups) rows.push_back(accuracy_row("", group));
  return rows;
}

Error no_cells(const std::string& question) {
  return {Exit::input_missing, question + ": its cells are missing; `make demo` makes them"};
}

/// Cells of one question, by the classifier that the question is about.
struct Compared {
  AccuracyRow alone;  ///< known windows only
  std::vector<AccuracyRow>
      methods;  ///< with the largest number of generated windows, the best first
  std::optional<AccuracyRow> nearest;  ///< known windows only, by the nearest neighbour
};

Compared compared(const std::vector<run::Diagnosis>& cells, const std::string& question) {
  const std::vector<ClassifierRows> blocks = by_classifier(rows_of_cells(cells));
  if (blocks.empty()) throw no_cells(question);
  const std::vector<AccuracyRow>& rows = blocks.front().rows;
  const auto alone = std::ranges::find(rows, augment::no_method, &AccuracyRow::method);
  const std::int64_t most =
      std::ranges::max_element(rows, {}, &AccuracyRow::generated_per_class)->generated_per_class;
  if (alone == rows.end() || most == 0) throw no_cells(question);
  Compared found{.alone = *alone, .methods = {}, .nearest = blocks.front().reference_row};
  std::ranges::copy_if(rows, std::back_inserter(found.methods),
                       [&](const AccuracyRow& row) { return row.generated_per_class == most; });
  std::ranges::stable_sort(found.methods, std::ranges::greater(),
                           [](const AccuracyRow& row) { return row.summary.mean; });
  return found;
}

/// Returns "shift (75 -> 98 %), not piae-dt (72 %)".
std::string what_helps(const Compared& cells) {
  std::vector<std::string> helping;
  std::vector<std::string> others;
  for (const AccuracyRow& row : cells.methods) {
    if (helps(row, cells.alone)) {
      helping.push_back(
          fmt::format("{} ({:.0f} -> {})", row.method, cells.alone.summary.mean, percent(row)));
    } else {
      others.push_back(fmt::format("{} ({})", row.method, percent(row)));
    }
  }
  if (helping.empty()) {
    return fmt::format("nothing: {} alone, {}", percent(cells.alone), listed(others));
  }
  return listed(helping) + (others.empty() ? "" : ", not " + listed(others));
}

std::string answer_at_the_same_speed(const Compared& cells) {
  std::string answer = what_helps(cells) + '.';
  if (!cells.nearest) return answer;
  const bool no_need =
      cells.nearest->summary.mean >= cells.methods.front().summary.mean - points_of_no_need;
  return answer + " Spectra " + (no_need ? "do not need help: " : "reach ") +
         percent(*cells.nearest) + (no_need ? "." : " alone.");
}

std::string question_at_the_other_speed(const run::Diagnosis& cell) {
  return fmt::format("Faults are known at {}, the machine runs at {}. What helps?",
                     listed(cell.known_at), listed(cell.tested_at));
}

/// Returns "strike-twin (66 -> 99 % by wdcnn-spectra); shift reaches 80 %."
std::string answer_at_the_other_speed(const Compared& cells) {
  const AccuracyRow& best = cells.methods.front();
  if (!helps(best, cells.alone)) return what_helps(cells) + '.';
  std::vector<std::string> others;
  for (auto row = cells.methods.begin() + 1; row != cells.methods.end(); ++row) {
    others.push_back(fmt::format("{} reaches {}", row->method, percent(*row)));
  }
  return fmt::format("{} ({:.0f} -> {} by {}){}.", best.method, cells.alone.summary.mean,
                     percent(best), best.classifier, others.empty() ? "" : "; " + listed(others));
}

/// Returns "Yes: 100 % correct by exclusion-rule; recording.txt: outer, correct."
std::string answer_without_a_fault(const std::vector<run::Diagnosis>& cells,
                                   const NamedRecording& recording) {
  const std::vector<AccuracyRow> rows = rows_of_cells(cells);
  if (rows.empty()) throw no_cells("the question without a known fault");
  const AccuracyRow& best =
      *std::ranges::max_element(rows, {}, [](const AccuracyRow& row) { return row.summary.mean; });
  const bool diagnoses = best.summary.mean >= percent_of_a_diagnosis && recording.correct;
  return fmt::format("{}: {} correct by {}; {}: {}, {}.", diagnoses ? "Yes" : "Not reliably",
                     percent(best), best.classifier, recording.file, recording.named,
                     recording.correct ? "correct" : "wrong");
}

std::string numbered(int number, const std::string& question, const std::string& answer) {
  constexpr std::size_t widest = 80;
  return text::wrap(fmt::format("{}. {}", number, question), widest) +
         text::wrap(answer, widest, 3);
}

}  // namespace

bool helps(const AccuracyRow& row, const AccuracyRow& alone) {
  const Pairs pairs = pairs_of(row, alone);
  bool all = !pairs.seeds.empty();
  for (std::size_t i = 0; i < pairs.seeds.size(); ++i) {
    all = all && pairs.first[i] - pairs.second[i] >= points_of_help;
  }
  return all;
}

std::string demo_answers(const DemoCells& cells) {
  const Compared same = compared(cells.same_speed, "the question at the same speed");
  const Compared other = compared(cells.other_speed, "the question at another speed");
  const std::size_t seeds = same.alone.seeds.size();
  return fmt::format("Three questions about a simulated bearing (percent correct, {}):\n\n",
                     counted(seeds, "seed")) +
         numbered(1, "A few windows of each fault are known. What helps a classifier of waveforms?",
                  answer_at_the_same_speed(same)) +
         numbered(2, question_at_the_other_speed(cells.other_speed.front()),
                  answer_at_the_other_speed(other)) +
         numbered(3, "No fault was ever recorded. Can one be diagnosed anyway?",
                  answer_without_a_fault(cells.no_fault, cells.recording));
}

}  // namespace piae::report
