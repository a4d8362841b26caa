#include "report/condition_notes.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "report/labels.hpp"

namespace piae::report {

namespace {

std::string kind_label(const std::string& name, const AccuracyRow& row) {
  return fmt::format("{} {:.1f} ({})", name, row.kind->mean, short_ratio_label(row.ratio));
}

}  // namespace

std::string conditions_note(const run::Results& results) {
  if (results.diagnoses.empty()) return "";
  const run::Diagnosis& any = results.diagnoses.front();
  if (!any.any_known) return "No fault window was known.";
  if (any.known_at.empty()) return "";
  return fmt::format("Faults are known at {}, and tested at {}.", listed(any.known_at),
                     listed(any.tested_at));
}

std::string kinds_sentence(const ClassifierRows& block) {
  if (!tell_kinds(block.rows)) return "";
  std::string text;
  const auto add = [&](const std::string& label) { text += (text.empty() ? "" : ", ") + label; };
  for (const std::string& method : methods_of(block.rows)) {
    const std::vector<AccuracyRow> own = rows_of(block.rows, method);
    add(kind_label(method_label(method),
                   *std::ranges::max_element(own, {}, &AccuracyRow::generated_per_class)));
  }
  if (block.bar) add(kind_label(bar_label(*block.bar), *block.bar));
  return "By kind of defect: " + text + ".";
}

}  // namespace piae::report
