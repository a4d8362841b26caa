#include "figures/cost.hpp"

#include <algorithm>
#include <optional>

#include "augment/catalogue.hpp"
#include "figures/intervals.hpp"
#include "run/step_costs.hpp"

namespace piae::figures {

namespace {

using report::AccuracyRow;

struct Priced {
  const AccuracyRow* row;
  double generator_s;
};

/// Returns each method's row with the most generated windows, if the cost of the method is known.
std::vector<Priced> priced(const Source& source, const std::vector<AccuracyRow>& rows) {
  std::vector<Priced> all;
  for (const AccuracyRow& row : rows) {
    const auto seconds = run::generator_seconds(source.costs(), row.dataset, row.method);
    if (!seconds || augment::is_ceiling(row.method)) continue;
    const auto same = std::ranges::find_if(
        all, [&](const Priced& each) { return each.row->method == row.method; });
    if (same == all.end()) {
      all.push_back({.row = &row, .generator_s = *seconds});
    } else if (row.generated_per_class > same->row->generated_per_class) {
      same->row = &row;
    }
  }
  std::ranges::stable_sort(all, {}, &Priced::generator_s);
  return all;
}

std::string group_of(const std::string& method) {
  switch (augment::find_entry(method)->kind) {
    case augment::Kind::ours:
      return "ours";
    case augment::Kind::control:
      return "control";
    default:
      return "paper";
  }
}

bool is_better(const Priced& a, const Priced& b) {
  const double gain = a.row->summary.mean - b.row->summary.mean;
  return gain >= 0 && a.generator_s <= b.generator_s && (gain > 0 || a.generator_s < b.generator_s);
}

std::optional<double> accuracy_without(const std::vector<AccuracyRow>& rows) {
  const auto none = std::ranges::find(rows, augment::no_method, &AccuracyRow::method);
  return none == rows.end() ? std::nullopt : std::optional(none->summary.mean);
}

}  // namespace

Numbers costs_of_accuracy(Source& source, const report::ClassifierRows& shown) {
  const std::vector<Priced> all = priced(source, shown.rows);
  if (all.empty()) throw LeftOut("no method of the run has a cost in jobs/costs.csv");
  const auto without = accuracy_without(shown.rows);
  if (!without) throw LeftOut("the run has no cell of the method none");
  Numbers numbers({"method", "group", "front", "ratio", "generator_s", "accuracy", "low", "high",
                   "gain", "s_per_point"});
  for (const Priced& each : all) {
    const AccuracyRow& row = *each.row;
    const bool is_on_front =
        std::ranges::none_of(all, [&](const Priced& other) { return is_better(other, each); });
    const double gain = row.summary.mean - *without;
    const std::vector<std::string> interval = shown_interval(row.summary);
    numbers.row({row.method, group_of(row.method), is_on_front ? "1" : "0", row.ratio,
                 digits(each.generator_s), digits(row.summary.mean), interval[0], interval[1],
                 digits(gain), gain > 0 ? digits(each.generator_s / gain) : ""});
  }
  return numbers;
}

}  // namespace piae::figures
