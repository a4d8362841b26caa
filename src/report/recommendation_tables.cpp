#include "report/recommendation_tables.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <span>

#include "augment/catalogue.hpp"
#include "diagnosis/catalogue.hpp"
#include "report/columns.hpp"
#include "report/labels.hpp"
#include "report/paper.hpp"

namespace piae::report {

namespace {

constexpr NumberStyle in_points{.decimals = 1, .sign = true};

/// Explains the table by effort.
constexpr const char* about_efforts =
    "Each line is the most accurate of those with the same effort (what must be generated or "
    "trained first), without ceilings. Behind: points minus the best; p, for lines with less "
    "effort than the best: Wilcoxon's signed-rank test, two-sided and exact, with Holm's "
    "correction over these lines. "
    "The recommended line has the least effort and is not significantly worse than the best; it is "
    "the best if there are too few seeds to decide. It is chosen and measured on the same test "
    "windows, so expect slightly less elsewhere. run.html of the run shows what each step took.";

/// Name of an effort in tables and its cost, by effort.
struct EffortWords {
  const char* label;
  const char* costs;
};
constexpr std::array<EffortWords, 6> words_of_efforts{{
    {"nothing", "It needs no preparation: no window is generated, and nothing is trained."},
    {"windows", "Windows must be generated; nothing is trained."},
    {"classifier", "The classifier must be trained; no window is generated."},
    {"windows + classifier",
     "The classifier must be trained; windows are generated without training."},
    {"generator", "A generator must be trained; the classifier is not trained."},
    {"generator + classifier", "A generator and the classifier must be trained."},
}};

const EffortWords& words_of(Effort effort) {
  return words_of_efforts.at(static_cast<std::size_t>(effort));
}

std::string counted_seeds(const Candidate& candidate) {
  return counted(candidate.row.seeds.size(), "seed");
}

/// Returns "95 % interval 94.0 to 96.4, "; "" without an interval.
std::string interval_words(const scoring::Summary& summary, NumberStyle style) {
  if (!summary.interval) return "";
  return fmt::format("95 % interval {} to {}, ", number_label(summary.interval->low, style),
                     number_label(summary.interval->high, style));
}

std::string what_to_take(const Recommendation& of) {
  const Candidate& taken = of.recommended();
  const AccuracyRow& row = taken.row;
  const std::string windows =
      row.method == augment::no_method
          ? "without any generated window"
          : fmt::format("with {} generated windows of each fault", row.generated_per_class);
  return fmt::format("Recommended on {}: {}, correct in {:.1f} % of the test windows ({}{}), {}.",
                     of.dataset, name_of(taken, of), row.summary.mean,
                     interval_words(row.summary, percent_style), counted_seeds(taken), windows);
}

/// Returns "none by nearest (-33.4 points, p 0.01)" for each candidate.
std::string listed_behind(const Recommendation& of, std::span<const Candidate> candidates,
                          bool with_p) {
  std::vector<std::string> words;
  for (const Candidate& each : candidates) {
    const std::string p = with_p ? fmt::format(", p {:.2g}", *each.behind->p_holm) : "";
    words.push_back(fmt::format("{} ({} points{})", name_of(each, of),
                                number_label(each.behind->paired.difference.mean, in_points), p));
  }
  return listed(words);
}

/// Explains why the best is recommended.
std::string why_the_best(const Recommendation& of) {
  if (of.compared == 1) return "Nothing else was compared.";
  const std::string most = fmt::format("It is the most accurate of the {} compared", of.compared);
  const std::span less = std::span(of.by_effort).first(of.best);
  if (less.empty()) return most + ", and none needs less.";
  if (!of.can_decide) {
    return fmt::format(
        "{}. With {} it cannot be decided if those that need less are as good: {}. At least {} "
        "seeds are needed.",
        most, counted_seeds(of.most_accurate()), listed_behind(of, less, false),
        of.seeds_to_decide());
  }
  return most +
         ", and those that need less are significantly worse: " + listed_behind(of, less, true) +
         ".";
}

/// Explains why something that takes less than the best is recommended.
std::string why_not_the_best(const Recommendation& of) {
  const PairedRow& behind = *of.recommended().behind;
  const std::span still_less = std::span(of.by_effort).first(of.taken);
  return fmt::format(
             "The most accurate of the {} compared is {} ({:.1f} %), but {} is not "
             "significantly worse ({} points, {}p {:.2g}) and needs less: {} instead of {}.",
             of.compared, name_of(of.most_accurate(), of), of.most_accurate().row.summary.mean,
             name_of(of.recommended(), of), number_label(behind.paired.difference.mean, in_points),
             interval_words(behind.paired.difference, in_points), *behind.p_holm,
             words_of(of.recommended().effort).label, words_of(of.most_accurate().effort).label) +
         (still_less.empty() ? ""
                             : " Those that need still less are significantly worse: " +
                                   listed_behind(of, still_less, true) + ".");
}

/// Returns a sentence on the class with the lowest recall; "" if all windows are recognised or none
/// was tested.
std::string least_recognised(const Recommendation& of) {
  const scoring::Confusion& confusion = of.recommended().confusion;
  std::string least;
  double percent = 100;
  for (std::size_t truth = 0; truth < confusion.classes; ++truth) {
    const scoring::Share recall = scoring::recall_of(confusion, truth);
    if (recall.of == 0 || recall.percent() >= percent) continue;
    percent = recall.percent();
    least = of.classes[truth].name;
  }
  return least.empty() ? ""
                       : fmt::format(" Class {} is recognised least, in {:.1f} % of its windows.",
                                     least, percent);
}

std::string what_it_gets_wrong(const Recommendation& of) {
  const scoring::Confusion& confusion = of.recommended().confusion;
  const scoring::Share missed = scoring::missed_faults(confusion, of.classes);
  const scoring::Share alarms = scoring::false_alarms(confusion, of.classes);
  std::vector<std::string> parts;
  if (missed.of > 0) {
    parts.push_back(
        fmt::format("{:.1f} % of the fault windows as healthy (missed faults)", missed.percent()));
  }
  if (alarms.of > 0) {
    parts.push_back(fmt::format("{:.1f} % of the healthy {} as a fault (false alarms)",
                                alarms.percent(), missed.of > 0 ? "ones" : "windows"));
  }
  return parts.empty() ? "" : "It classifies " + listed(parts) + "." + least_recognised(of);
}

/// A line of the table by effort or by ratio.
struct EffortRow {
  const Recommendation* of;
  std::size_t i;
  [[nodiscard]] const Candidate& candidate() const { return of->by_effort[i]; }
  [[nodiscard]] const scoring::Summary& summary() const { return candidate().row.summary; }
  [[nodiscard]] scoring::Share missed() const {
    return scoring::missed_faults(candidate().confusion, of->classes);
  }
  [[nodiscard]] scoring::Share alarms() const {
    return scoring::false_alarms(candidate().confusion, of->classes);
  }
};

using EffortColumns = Columns<EffortRow>;

std::string effort_row_name(const EffortRow& row) { return name_of(row.candidate(), *row.of); }

text::Cell accuracy_of(const EffortRow& row) {
  text::Cell cell = number_cell(row.summary().mean, percent_style);
  cell.source =
      fmt::format("attribute accuracy of {} diagnoses at {}", row.candidate().row.seeds.size(),
                  short_ratio_label(row.candidate().row.ratio));
  return cell;
}

text::Cell interval_of(const EffortRow& row) {
  return interval_label(row.summary(), percent_style);
}

text::Cell taken_cell(const EffortRow& row) {
  const bool is_taken = row.i == row.of->taken;
  text::Cell cell = is_taken ? "yes" : "";
  cell.field = is_taken ? "1" : "0";
  cell.looks = is_taken ? "helps" : "";
  return cell;
}

/// Returns "-3.2" points; no_number for the best itself.
text::Cell behind_cell(const EffortRow& row) {
  const auto& of = row.candidate().behind;
  text::Cell cell = of ? number_label(of->paired.difference.mean, in_points) : no_number;
  cell.field = of ? four_decimals(of->paired.difference.mean) : "";
  return cell;
}

/// Returns Holm's p; no_number if the candidate is not tested.
text::Cell holm_cell(const EffortRow& row) {
  const auto& of = row.candidate().behind;
  const bool is_tested = of && of->p_holm;
  text::Cell cell = is_tested ? fmt::format("{:.3g}", *of->p_holm) : no_number;
  cell.field = is_tested ? fmt::format("{:.6g}", *of->p_holm) : "";
  return cell;
}

/// Returns each effort at one ratio. CSV has more columns and gets the efforts at each ratio.
text::Table table_by_effort(const std::vector<EffortRow>& rows) {
  EffortColumns columns;
  const auto row_of = [](const EffortRow& row) { return row.candidate().row; };
  columns.field("dataset", [](const EffortRow& row) { return row.of->dataset; })
      .field("ratio", [](const EffortRow& row) { return row.of->ratio; })
      .words(
          "it takes", [](const EffortRow& row) { return words_of(row.candidate().effort).label; },
          "effort")
      .words("most accurate", effort_row_name)
      .words("take", taken_cell)
      .field("method", [=](const EffortRow& row) { return row_of(row).method; })
      .field("classifier", [=](const EffortRow& row) { return row_of(row).classifier; })
      .field("seeds", [=](const EffortRow& row) { return count_cell(row_of(row).seeds.size()); })
      .summary_fields("mean", "", &EffortRow::summary)
      .numbers("accuracy %", accuracy_of)
      .numbers("95 % interval", interval_of)
      .numbers("behind", behind_cell, "behind")
      .numbers("p", holm_cell, "p_holm")
      .add({"missed faults", true, "missed_faults", text::Shown::on_pages},
           [](const EffortRow& row) { return share_cell(row.missed()); })
      .add({"false alarms", true, "false_alarms", text::Shown::on_pages},
           [](const EffortRow& row) { return share_cell(row.alarms()); })
      .field("best", [](const EffortRow& row) { return row.i == row.of->best ? "1" : "0"; })
      .field("recommended", taken_cell);
  return columns.table(rows);
}

std::vector<std::string> findings_of(const Recommendation& of) {
  std::vector<std::string> sentences = recommendation_sentences(of);
  if (!of.left_out.empty()) {
    sentences.push_back(
        "Not compared, because they lack seeds that the others have: " + listed(of.left_out) + ".");
  }
  return sentences;
}

std::vector<EffortRow> efforts_of(const Recommendation& of) {
  std::vector<EffortRow> rows;
  for (std::size_t i = 0; i < of.by_effort.size(); ++i) rows.push_back({&of, i});
  return rows;
}

text::Table table_by_class(const Recommendation& of) {
  text::Table table({"class", "test windows", "recognised"}, 1);
  const scoring::Confusion& confusion = of.recommended().confusion;
  for (std::size_t truth = 0; truth < confusion.classes; ++truth) {
    const scoring::Share recall = scoring::recall_of(confusion, truth);
    table.row({of.classes[truth].name, count_cell(recall.of), recall_cell(recall)});
  }
  return table;
}

text::Table table_by_ratio(const std::vector<Recommendation>& all) {
  std::vector<EffortRow> rows;
  for (const Recommendation& each : all) rows.push_back({&each, each.taken});
  EffortColumns columns;
  columns.words("ratio", [](const EffortRow& row) { return row.of->ratio_label; })
      .words("take", effort_row_name)
      .numbers("accuracy %", accuracy_of)
      .numbers("95 % interval", interval_of)
      .numbers("missed faults", [](const EffortRow& row) { return share_cell(row.missed()); })
      .numbers("false alarms", [](const EffortRow& row) { return share_cell(row.alarms()); });
  return columns.table(rows);
}

}  // namespace

std::string name_of(const Candidate& candidate, const Recommendation& of) {
  const AccuracyRow& row = candidate.row;
  return of.several_classifiers ? row.method + " by " + diagnosis::marked_name(row.classifier)
                                : run::name_by(row.method, row.classifier);
}

std::vector<std::string> recommendation_sentences(const Recommendation& recommendation) {
  std::vector<std::string> sentences{what_to_take(recommendation),
                                     recommendation.taken == recommendation.best
                                         ? why_the_best(recommendation)
                                         : why_not_the_best(recommendation),
                                     words_of(recommendation.recommended().effort).costs};
  std::string wrong = what_it_gets_wrong(recommendation);
  if (!wrong.empty()) sentences.push_back(std::move(wrong));
  return sentences;
}

std::vector<Section> recommendation_sections(const std::vector<Recommendation>& all) {
  const Recommendation* const main = main_recommendation(all);
  if (main == nullptr) return {};
  const std::string name = name_of(main->recommended(), *main);
  std::vector<Section> sections;
  const auto add = [&](Section section) {
    sections.push_back(PaperReference(main->dataset).none().of(std::move(section)));
  };
  add({.key = "recommendation",
       .title = "Which method to take on " + main->dataset,
       .note = about_efforts,
       .table = table_by_effort(efforts_of(*main)),
       .findings = findings_of(*main)});
  if (all.size() > 1) {
    add({.key = "recommendation-ratios",
         .title = "Which method to take at each ratio on " + main->dataset,
         .note = "Chosen as in the table above. Missed faults: percent of the fault windows that "
                 "are classified as healthy; false alarms: percent of the healthy windows that are "
                 "classified as a fault.",
         .table = table_by_ratio(all)});
  }
  if (main->recommended().confusion.classes > 0) {
    add({.key = "recommendation-recall",
         .title = "Recall of " + name + " on " + main->dataset + ", percent",
         .note = fmt::format("Test windows of all seeds together. {} is recommended at {}.", name,
                             main->ratio_label),
         .table = table_by_class(*main)});
  }
  return sections;
}

std::string recommendation_csv(const std::vector<Recommendation>& all) {
  std::vector<EffortRow> rows;
  for (const Recommendation& each : all)
    std::ranges::copy(efforts_of(each), std::back_inserter(rows));
  return table_by_effort(rows).csv();
}

}  // namespace piae::report
