#include "page/recommendation_view.hpp"

#include <spdlog/fmt/fmt.h>

#include "page/links.hpp"
#include "page/recall_cells.hpp"
#include "page/table.hpp"
#include "report/labels.hpp"
#include "report/recommendation_tables.hpp"
#include "report/recommendation_words.hpp"

namespace piae::page {

namespace {

using report::Candidate;
using report::Recommendation;

Cell accuracy_cell_of(const Candidate& candidate) {
  const report::AccuracyRow& row = candidate.row;
  return {.content = report::number_label(row.summary.mean, report::percent_style),
          .number = row.summary.mean,
          .from = fmt::format("attribute accuracy of {} diagnoses at {}", row.seeds.size(),
                              report::short_ratio_label(row.ratio))};
}

Table table_of_efforts(const Recommendation& of) {
  Table table{.caption = "The most accurate on " + of.dataset + " of each effort, percent, at " +
                         of.ratio_label,
              .columns = {{"it takes"},
                          {"most accurate"},
                          {"take"},
                          {"accuracy", true},
                          {"95 % interval", true},
                          {"behind, points", true},
                          {"p (Holm)", true},
                          {"missed faults", true},
                          {"false alarms", true}}};
  for (std::size_t i = 0; i < of.by_effort.size(); ++i) {
    const Candidate& each = of.by_effort[i];
    table.rows.push_back(
        {.cells = {{.content = report::effort_label(each.effort)},
                   {.content = report::name_of(each, of)},
                   {.content = i == of.taken ? "✔ yes" : "", .looks = i == of.taken ? "helps" : ""},
                   accuracy_cell_of(each),
                   {.content = report::interval_label(each.row.summary, report::percent_style)},
                   {.content = report::behind_label(each)},
                   {.content = report::holm_label(each)},
                   share_cell(scoring::missed_faults(each.confusion, of.classes)),
                   share_cell(scoring::false_alarms(each.confusion, of.classes))}});
  }
  table.below = report::about_efforts;
  return table;
}

Table table_of_ratios(const std::vector<Recommendation>& all) {
  Table table{
      .caption = "Which method to take at each ratio on " + all.front().dataset + ", percent",
      .columns = {{"ratio"},
                  {"take"},
                  {"accuracy", true},
                  {"95 % interval", true},
                  {"missed faults", true},
                  {"false alarms", true}}};
  for (const Recommendation& each : all) {
    const Candidate& taken = each.recommended();
    table.rows.push_back(
        {.cells = {{.content = each.ratio_label},
                   {.content = report::name_of(taken, each)},
                   accuracy_cell_of(taken),
                   {.content = report::interval_label(taken.row.summary, report::percent_style)},
                   share_cell(scoring::missed_faults(taken.confusion, each.classes)),
                   share_cell(scoring::false_alarms(taken.confusion, each.classes))}});
  }
  return table;
}

Table table_of_classes(const Recommendation& of) {
  Table table{.caption = "What " + report::name_of(of.recommended(), of) + " recognises on " +
                         of.dataset + ", percent",
              .columns = {{"class"}, {"test windows", true}, {"recognised", true}}};
  const scoring::Confusion& confusion = of.recommended().confusion;
  for (std::size_t truth = 0; truth < confusion.classes; ++truth) {
    const scoring::Share recall = scoring::recall_of(confusion, truth);
    table.rows.push_back(
        {.cells = {{.content = of.classes[truth].name},
                   number_cell(static_cast<double>(recall.of), std::to_string(recall.of)),
                   recall_cell(recall)}});
  }
  table.below = "Of the test windows of all seeds together.";
  return table;
}

Html sentences_in_html(const Recommendation& of) {
  Html view;
  for (const std::string& sentence : report::recommendation_sentences(of)) {
    view += view.empty() ? element("p", {{"class", "verdict"}}, sentence) : element("p", sentence);
  }
  const std::string left_out = report::not_compared_note(of);
  if (!left_out.empty()) view += element("p", left_out);
  return view + element("p", Html("What training and generating took here, which differs from "
                                  "run to run: ") +
                                 file_link("run.html") + ".");
}

}  // namespace

Html recommendation_view(const DatasetContents& contents) {
  const Recommendation* const main = report::main_recommendation(contents.recommendations);
  if (main == nullptr) return element("p", "No diagnosis is there yet.");
  Html tables =
      element("div", html(table_of_efforts(*main))) + element("div", html(table_of_classes(*main)));
  if (contents.recommendations.size() > 1) {
    tables += element("div", html(table_of_ratios(contents.recommendations)));
  }
  return sentences_in_html(*main) + element("div", {{"class", "pair"}}, tables);
}

}  // namespace piae::page
