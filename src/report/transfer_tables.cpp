#include "report/transfer_tables.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "augment/catalogue.hpp"
#include "diagnosis/catalogue.hpp"
#include "report/accuracies.hpp"
#include "report/columns.hpp"
#include "report/gaps.hpp"
#include "report/labels.hpp"

namespace piae::report {

namespace {

using Cells = std::vector<std::string>;

constexpr const char* mark_of_recorded = "✓";
constexpr const char* mark_of_best = "↑";

/// Returns the rows of the main tables: methods by their recorded inputs, and the references.
std::vector<const GroupRow*> shown_rows(const TransferGroup& group, Question question) {
  std::vector<const GroupRow*> rows = group.recorded(question);
  std::ranges::copy(group.references(question), std::back_inserter(rows));
  return rows;
}

/// Returns "smote" and "wdcnn-spectra". References have the same names as in other tables.
Cells shown_names(const GroupRow& row, Question question) {
  if (TransferGroup::is_reference(row, question)) return {reference_label(row.mean.row), no_number};
  return {method_label(row.method), diagnosis::marked_name(row.classifier)};
}

/// Returns the title or key of a table that exists once for each question.
std::string titled(Question question, const std::string& title) {
  return title + (question == Question::by_class ? "" : " by fault type") + ", percent";
}
std::string keyed(Question question, const std::string& key) {
  return question == Question::by_class ? key : "kind-" + key;
}

std::string about_mean(const TransferGroup& group, Question question) {
  if (question == Question::by_class) {
    return "Shown: the classifier, chosen for each method on other seeds, so that no number here "
           "is "
           "the best of several.";
  }
  return std::string(
             "A fault that is classified as another of the same type, such as one of another size, "
             "counts as correct. Shown: ") +
         (group.choices.type_inputs.empty() ? "as above."
                                            : "as above, but chosen for fault types.");
}

Section mean_section(const TransferGroup& group, Question question) {
  text::Table table({"method", "shown", "accuracy", "95 % interval"}, 2);
  for (const GroupRow* const row : shown_rows(group, question)) {
    Cells cells = shown_names(*row, question);
    const scoring::Summary& summary = answers(row->mean, question).summary;
    cells.insert(cells.end(), {mean_label(summary), interval_label(summary)});
    table.row(cells);
  }
  return {keyed(question, "mean"), titled(question, "Mean over the data sets"),
          about_mean(group, question), table};
}

Section difference_section(const TransferGroup& group) {
  return {"difference", "Mean of " + group.choices.against + " minus that of each other, points",
          paired_note(group.differences, "Each uses the classifier shown above."),
          paired_table(group.differences)};
}

Section datasets_section(const TransferGroup& group, Question question) {
  Cells header{"method", "shown"};
  header.insert(header.end(), group.datasets.begin(), group.datasets.end());
  text::Table table(header, 2);
  for (const GroupRow* const row : shown_rows(group, question)) {
    Cells cells = shown_names(*row, question);
    for (const GroupCell& cell : row->datasets) {
      cells.push_back(mean_label(answers(cell, question).summary));
    }
    table.row(cells);
  }
  return {keyed(question, "datasets"), titled(question, "Each data set"), "", table};
}

std::string input_label(const GroupRow& row, Question question) {
  const Marks& marks = row.marks(question);
  const std::string text = std::string(marks.recorded ? mark_of_recorded : "") +
                           std::string(marks.best ? mark_of_best : "");
  return number_label(answers(row.mean, question).summary.mean) + (text.empty() ? "" : " " + text);
}

const GroupRow* group_row_of(const TransferGroup& group, const std::string& method,
                             const std::string& classifier) {
  const auto found = std::ranges::find_if(group.rows, [&](const GroupRow& row) {
    return row.method == method && row.classifier == classifier;
  });
  return found == group.rows.end() ? nullptr : &*found;
}

/// Returns how many points the recorded classifier of a method is below its best one in this run.
std::string lost_label(const TransferGroup& group, const std::string& method, Question question) {
  const std::vector<const GroupRow*> recorded = group.recorded(question);
  const auto own = std::ranges::find(recorded, method, &GroupRow::method);
  const GroupRow* const best = group.best_of(method, question);
  if (own == recorded.end() || best == nullptr) return no_number;
  return number_label(answers(best->mean, question).summary.mean -
                      answers((*own)->mean, question).summary.mean);
}

/// Returns the classifiers that have a row.
Cells classifiers_of(const TransferGroup& group) {
  Cells names;
  for (const diagnosis::Classifier& each : diagnosis::classifiers()) {
    if (std::ranges::count(group.rows, each.name, &GroupRow::classifier) > 0) {
      names.emplace_back(each.name);
    }
  }
  return names;
}

Cells group_methods(const TransferGroup& group) {
  Cells names;
  for (const GroupRow& row : group.rows) {
    if (names.empty() || names.back() != row.method) names.push_back(row.method);
  }
  return names;
}

/// Returns the best classifiers of this run in the format of pipeline/protocol.toml.
std::string best_inputs(const TransferGroup& group, Question question) {
  Cells words;
  for (const GroupRow& row : group.rows) {
    if (!row.marks(question).best) continue;
    words.push_back(fmt::format("\"{}={}\"", row.method, row.classifier));
  }
  return fmt::format("{}inputs = [{}]", question == Question::by_class ? "" : "kind-",
                     fmt::join(words, ", "));
}

std::string about_inputs(const TransferGroup& group, Question question) {
  const std::string best = "The best here are: " + best_inputs(group, question);
  if (question == Question::by_type) return "As above. " + best;
  return fmt::format(
      "{} marks the classifier that was chosen on other seeds, which all other tables show; {} "
      "marks "
      "the best one in this run: record it if these seeds are for choosing; otherwise it is not a "
      "result. Lost: points by which the first is below the second. {}",
      mark_of_recorded, mark_of_best, best);
}

Section inputs_section(const TransferGroup& group, Question question) {
  const Cells classifiers = classifiers_of(group);
  Cells header{"method"};
  std::ranges::transform(classifiers, std::back_inserter(header), diagnosis::marked_name);
  header.emplace_back("lost");
  text::Table table(header, 1);
  for (const std::string& method : group_methods(group)) {
    Cells cells{method_label(method)};
    for (const std::string& classifier : classifiers) {
      const GroupRow* const row = group_row_of(group, method, classifier);
      cells.push_back(row == nullptr ? no_number : input_label(*row, question));
    }
    cells.push_back(lost_label(group, method, question));
    table.row(cells);
  }
  return {keyed(question, "inputs"),
          titled(question, "Each method by each classifier: mean over the data sets"),
          about_inputs(group, question), table};
}

std::string about(const TransferGroup& group) {
  const auto generated = std::ranges::max_element(
      group.rows, {}, [](const GroupRow& row) { return row.mean.row.generated_per_class; });
  const AccuracyRow& row = generated->mean.row;
  return fmt::format(
      "Accuracy of each method if faults are known in one condition of the machine and tested in "
      "another: the mean over {}, with {} generated windows of each fault ({}), seed{} {}, "
      "split {}. For each seed the accuracy is first averaged over the data sets; numbers are the "
      "mean ± the sample standard deviation over the seeds. {}",
      fmt::join(group.datasets, ", "), row.generated_per_class, short_ratio_label(row.ratio),
      group.seeds.size() == 1 ? "" : "s", seed_list(group.seeds), to_string(group.protocol),
      about_intervals);
}

/// Returns a note on methods without a recorded input; "" if there are none.
std::string about_missing_choices(const TransferGroup& group) {
  Cells without = group_methods(group);
  for (const GroupRow* const row : group.recorded()) std::erase(without, row->method);
  if (without.empty()) return "";
  return fmt::format(
      "[transfer.{}] of pipeline/protocol.toml does not record a classifier for {}: see the table "
      "by "
      "classifier.",
      group.choices.group, fmt::join(without, ", "));
}

void add_sections(const TransferGroup& group, Question question, Document& document) {
  const bool shown = !shown_rows(group, question).empty();
  if (shown) document.sections.push_back(mean_section(group, question));
  if (question == Question::by_class && !group.differences.empty()) {
    document.sections.push_back(difference_section(group));
  }
  if (shown) document.sections.push_back(datasets_section(group, question));
  document.sections.push_back(inputs_section(group, question));
}

std::string role_of(const TransferGroup& group, const GroupRow& row) {
  if (row.method == group.choices.against) return "against";
  if (augment::is_ceiling(row.method)) return "ceiling";
  return TransferGroup::is_reference(row) ? "bar" : "method";
}

std::string yes_or_no(bool yes) { return yes ? "1" : "0"; }

/// One seed of a cell, or the mean over its seeds.
struct TransferLine {
  const GroupRow* of;
  const GroupCell* cell;
  std::optional<std::size_t> seed;

  /// Returns the value of one seed without spread, or the summary over the seeds.
  [[nodiscard]] scoring::Summary summary_of(const AccuracyRow& row) const {
    if (!seed) return row.summary;
    scoring::Summary summary;
    summary.mean = row.values[*seed];
    return summary;
  }
  [[nodiscard]] scoring::Summary accuracy() const { return summary_of(cell->row); }
  [[nodiscard]] std::optional<scoring::Summary> type_accuracy() const {
    return cell->type_accuracy ? std::optional(summary_of(*cell->type_accuracy)) : std::nullopt;
  }
};

std::vector<TransferLine> lines_of(const GroupRow& row) {
  std::vector<TransferLine> lines;
  const auto add = [&](const GroupCell& cell) {
    for (std::size_t i = 0; i < cell.row.seeds.size(); ++i) lines.push_back({&row, &cell, i});
    lines.push_back({&row, &cell, std::nullopt});
  };
  for (const GroupCell& cell : row.datasets) add(cell);
  add(row.mean);
  return lines;
}

}  // namespace

std::string transfer_csv(const TransferGroup& group) {
  using Line = TransferLine;
  std::vector<Line> lines;
  for (const GroupRow& row : group.rows)
    std::ranges::copy(lines_of(row), std::back_inserter(lines));
  Columns<Line> columns;
  columns.field("dataset", [](const Line& line) { return line.cell->row.dataset; })
      .field("speed_ratio",
             [](const Line& line) { return four_decimals(line.cell->row.speed_ratio); })
      .field("method", [](const Line& line) { return line.of->method; })
      .field("role", [&](const Line& line) { return role_of(group, *line.of); })
      .field("classifier", [](const Line& line) { return line.of->classifier; })
      .field("recorded", [](const Line& line) { return yes_or_no(line.of->by_class.recorded); })
      .field("best", [](const Line& line) { return yes_or_no(line.of->by_class.best); })
      .field("ratio", [](const Line& line) { return line.of->mean.row.ratio; })
      .field("seed",
             [](const Line& line) {
               return line.seed ? std::to_string(line.cell->row.seeds[*line.seed]) : "mean";
             })
      .summary_fields("accuracy", "", &Line::accuracy)
      .summary_fields("kind", "kind_", &Line::type_accuracy)
      .field("kind_recorded", [](const Line& line) { return yes_or_no(line.of->by_type.recorded); })
      .field("kind_best", [](const Line& line) { return yes_or_no(line.of->by_type.best); });
  return columns.table(lines).csv();
}

std::string transfer_comparisons_csv(const TransferGroup& group) {
  struct Line {
    const PairedRow* row;
    const GroupRow* other;
  };
  std::vector<Line> lines;
  const std::vector<const GroupRow*> others = group.others();
  for (std::size_t i = 0; i < group.differences.size(); ++i) {
    lines.push_back({&group.differences[i], others[i]});
  }
  Columns<Line> columns;
  columns.field("group", [&](const Line&) { return group.choices.group; })
      .field("ratio", [](const Line& line) { return line.row->ratio; })
      .field("method", [&](const Line&) { return group.own()->method; })
      .field("classifier", [&](const Line&) { return group.own()->classifier; })
      .field("minus", [](const Line& line) { return line.other->method; })
      .field("minus_classifier", [](const Line& line) { return line.other->classifier; })
      .with(paired_columns(), [](const Line& line) { return *line.row; });
  return columns.table(lines).csv();
}

Document transfer_document(const TransferGroup& group) {
  Document document{.key = "transfer-" + group.choices.group,
                    .title = "Faults known in another condition: " + group.choices.group};
  document.paragraphs.push_back(about(group));
  const std::string adapting = about_adapting(classifiers_of(group));
  if (!adapting.empty()) document.paragraphs.push_back(adapting);
  const std::string missing = about_missing_choices(group);
  if (!missing.empty()) document.paragraphs.push_back(missing);
  if (group.own() == nullptr) {
    document.paragraphs.push_back(group.choices.against +
                                  " by its own classifier is not among these cells, so nothing is "
                                  "subtracted from it.");
  }
  add_sections(group, Question::by_class, document);
  if (group.has_fault_types()) add_sections(group, Question::by_type, document);
  return document;
}

}  // namespace piae::report
