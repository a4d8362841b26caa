#include "report/recommendation_tables.hpp"

#include <spdlog/fmt/fmt.h>

#include "report/csv_fields.hpp"
#include "report/labels.hpp"
#include "report/paper_reference.hpp"
#include "report/recommendation_words.hpp"
#include "text/csv.hpp"

namespace piae::report {

namespace {

std::string recommendation_note(const Recommendation& recommendation) {
  std::string note;
  for (const std::string& sentence : recommendation_sentences(recommendation)) {
    note += sentence + " ";
  }
  const std::string left_out = not_compared_note(recommendation);
  return note + (left_out.empty() ? "" : left_out + " ") + about_efforts +
         " What each step took here is in run.html of the run.";
}

text::Table table_by_effort(const Recommendation& of) {
  text::Table table(
      {"it takes", "most accurate", "take", "accuracy %", "95 % interval", "behind", "p"}, 3);
  for (std::size_t i = 0; i < of.by_effort.size(); ++i) {
    const Candidate& each = of.by_effort[i];
    table.row({effort_label(each.effort), name_of(each, of), i == of.taken ? "yes" : "",
               number_label(each.row.summary.mean, percent_style),
               interval_label(each.row.summary, percent_style), behind_label(each),
               holm_label(each)});
  }
  return table;
}

text::Table table_by_class(const Recommendation& of) {
  text::Table table({"class", "test windows", "recognised"}, 1);
  const scoring::Confusion& confusion = of.recommended().confusion;
  for (std::size_t truth = 0; truth < confusion.classes; ++truth) {
    const scoring::Share recall = scoring::recall_of(confusion, truth);
    table.row({of.classes[truth].name, std::to_string(recall.of), share_label(recall)});
  }
  return table;
}

text::Table table_by_ratio(const std::vector<Recommendation>& all) {
  text::Table table(
      {"ratio", "take", "accuracy %", "95 % interval", "missed faults", "false alarms"}, 2);
  for (const Recommendation& each : all) {
    const Candidate& taken = each.recommended();
    table.row({each.ratio_label, name_of(taken, each),
               number_label(taken.row.summary.mean, percent_style),
               interval_label(taken.row.summary, percent_style),
               share_label(scoring::missed_faults(taken.confusion, each.classes)),
               share_label(scoring::false_alarms(taken.confusion, each.classes))});
  }
  return table;
}

std::string percent_field(const scoring::Share& share) {
  return share.of == 0 ? "" : four_decimals(share.percent());
}

std::string csv_line_of(const Recommendation& of, std::size_t i) {
  const Candidate& each = of.by_effort[i];
  const AccuracyRow& row = each.row;
  const auto& behind = each.behind;
  return joined_csv_line({{of.dataset, of.ratio, effort_label(each.effort), row.method,
                           row.classifier, std::to_string(row.seeds.size())},
                          mean_fields(row.summary),
                          interval_fields(row.summary),
                          {behind ? four_decimals(behind->paired.difference.mean) : "",
                           behind && behind->p_holm ? fmt::format("{:.6g}", *behind->p_holm) : "",
                           percent_field(scoring::missed_faults(each.confusion, of.classes)),
                           percent_field(scoring::false_alarms(each.confusion, of.classes)),
                           i == of.best ? "1" : "0", i == of.taken ? "1" : "0"}});
}

}  // namespace

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
       .note = recommendation_note(*main),
       .table = table_by_effort(*main)});
  if (all.size() > 1) {
    add({.key = "recommendation-ratios",
         .title = "Which method to take at each ratio on " + main->dataset,
         .note = "Chosen as in the table above. Missed faults: percent of "
                 "the fault windows that are taken for healthy; false alarms: of the healthy ones "
                 "that are taken for a fault.",
         .table = table_by_ratio(all)});
  }
  if (main->recommended().confusion.classes > 0) {
    add({.key = "recommendation-recall",
         .title = "What " + name + " recognises on " + main->dataset + ", percent",
         .note = fmt::format("Of the test windows of all seeds together. {} is what is "
                             "recommended at {}.",
                             name, main->ratio_label),
         .table = table_by_class(*main)});
  }
  return sections;
}

std::string recommendation_csv(const std::vector<Recommendation>& all) {
  std::string text = text::csv_line({"dataset", "ratio", "effort", "method", "classifier", "seeds",
                                     "mean", "std", "ci95_low", "ci95_high", "behind", "p_holm",
                                     "missed_faults", "false_alarms", "best", "recommended"});
  for (const Recommendation& each : all) {
    for (std::size_t i = 0; i < each.by_effort.size(); ++i) text += csv_line_of(each, i);
  }
  return text;
}

}  // namespace piae::report
