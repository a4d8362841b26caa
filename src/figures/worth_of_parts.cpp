#include "figures/worth_of_parts.hpp"

#include <algorithm>

#include "augment/catalogue.hpp"
#include "figures/intervals.hpp"
#include "figures/stored_table.hpp"
#include "figures/trained_options.hpp"
#include "report/parts.hpp"

namespace piae::figures {

namespace {

/// Returns the sweep of a table. It requests nothing, so all cells of the run count.
report::Sweep sweep_of(const std::string& dataset, const StoredTable& table) {
  report::Sweep sweep{.method = table.at(0, "method"),
                      .classifier = table.at(0, "classifier"),
                      .grid = {.dataset = dataset, .scored = {}, .combinations = {}, .seeds = {}},
                      .points = {}};
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const report::SweepPoint point{.factor = table.at(i, "factor"),
                                   .value = table.at(i, "value"),
                                   .centre = table.at(i, "centre") == "1"};
    const auto is_same = [&](const report::SweepPoint& other) {
      return other.factor == point.factor && other.value == point.value;
    };
    if (std::ranges::none_of(sweep.points, is_same)) sweep.points.push_back(point);
  }
  return sweep;
}

/// Returns the mean accuracy of the unchanged method at the seeds of a difference.
double whole_of(const std::vector<report::PartRow>& rows, const report::PairedRow& difference) {
  const auto whole = std::ranges::find_if(rows, [&](const report::PartRow& row) {
    return row.moved.point.factor.empty() && row.moved.accuracy.ratio == difference.ratio;
  });
  double sum = 0;
  for (const std::int64_t seed : difference.seeds) sum += *whole->moved.accuracy.at(seed);
  return sum / static_cast<double>(difference.seeds.size());
}

/// Adds a row for each seed, and one for their mean. `fields` precede the seed.
void add_difference(Numbers& numbers, const std::vector<std::string>& fields,
                    const report::PairedRow& difference, double whole) {
  const auto add = [&](const std::string& seed, double value, const std::string& low,
                       const std::string& high) {
    std::vector<std::string> row = fields;
    row.insert(row.end(), {seed, digits(value), low, high, digits(whole)});
    numbers.row(row);
  };
  for (std::size_t i = 0; i < difference.seeds.size(); ++i) {
    add(std::to_string(difference.seeds[i]), difference.differences[i], "", "");
  }
  const std::vector<std::string> interval = shown_interval(difference.paired.difference);
  add("mean", difference.paired.difference.mean, interval[0], interval[1]);
}

Numbers numbers_of(const Source& source, const report::Sweep& sweep) {
  run::Results results;
  const std::vector<report::PartRow> rows = report::part_rows(
      report::sweep_rows(source.layout(), sweep, run::Held(source.layout()), results));
  require_whole(results);
  Numbers numbers({"setting", "instead_of", "ratio", "classifier", "seed", "difference", "low",
                   "high", "whole"});
  for (const report::PartRow& row : rows) {
    if (!row.difference) continue;
    const report::SweepPoint& point = row.moved.point;
    const artefact::Reader model(source.layout().model(sweep.method, row.difference->seeds.front()),
                                 "model");
    const toml::table options = options_of_training(model);
    const auto has = options[point.factor].value_or<std::string>("");
    add_difference(numbers,
                   {point.factor + "=" + shown_value(point.value), shown_value(has),
                    row.moved.accuracy.ratio, sweep.classifier},
                   *row.difference, whole_of(rows, *row.difference));
  }
  return numbers;
}

}  // namespace

std::vector<Picture> worth_of_parts(Source& source) {
  std::vector<Picture> pictures;
  for (const std::string& method : augment::method_names()) {
    const std::filesystem::path table = source.layout().sweep_csv(method);
    if (method == augment::paper_method() || !std::filesystem::exists(table)) continue;
    const report::Sweep sweep = sweep_of(source.grid().dataset, StoredTable(table));
    pictures.push_back({.part = method, .numbers = numbers_of(source, sweep)});
  }
  if (pictures.empty()) {
    throw LeftOut("no method other than " + augment::paper_method() +
                  " has a sweep; run `make sweep` with others in METHODS");
  }
  return pictures;
}

}  // namespace piae::figures
