#include "report/sweep.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "base/error.hpp"
#include "report/csv_fields.hpp"
#include "report/labels.hpp"
#include "report/paper_methods.hpp"
#include "text/csv.hpp"

namespace piae::report {

namespace {

SweepPoint parse_point(const std::string& word, const std::vector<std::string>& centre) {
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == word.size() ||
      word.find('/') != std::string::npos) {
    throw Error(Exit::usage, "--points: '" + word + "' is not FACTOR=VALUE, such as batch=1");
  }
  return {.factor = word.substr(0, equals),
          .value = word.substr(equals + 1),
          .centre = std::ranges::find(centre, word) != centre.end()};
}

std::optional<SweepRow> row_of(const run::Layout& layout, const Sweep& sweep,
                               const SweepPoint& point, const run::Combination& combination,
                               run::Results& results) {
  const std::size_t before = results.diagnoses.size();
  const run::Series series{.name = point.factor + " " + point.value,
                           .folder = point.folder(),
                           .combination = combination};
  run::collect_diagnoses(layout, sweep.grid, series, results);
  std::vector<double> percents;
  for (std::size_t i = before; i < results.diagnoses.size(); ++i) {
    percents.push_back(100 * results.diagnoses[i].accuracy);
  }
  if (percents.size() < sweep.grid.seeds.size()) return std::nullopt;
  return SweepRow{.point = point,
                  .ratio = combination.ratio,
                  .true_ratio = results.diagnoses.back().true_ratio,
                  .summary = scoring::summarise(percents)};
}

std::vector<std::string> factors_of(const Sweep& sweep) {
  std::vector<std::string> factors;
  for (const SweepPoint& point : sweep.points) {
    if (std::ranges::find(factors, point.factor) == factors.end()) factors.push_back(point.factor);
  }
  return factors;
}

/// A line for each value of the factor, with the interval of the mean in the line below.
text::Table factor_table(const std::string& factor, const Sweep& sweep,
                         const std::vector<SweepRow>& rows) {
  const std::size_t ratios = sweep.grid.combinations.size();
  std::vector<std::string> header{factor, ""};
  for (std::size_t i = 0; i < ratios; ++i) {
    header.push_back(ratio_label(rows[i].ratio, rows[i].true_ratio));
  }
  text::Table table(header, 2);
  for (std::size_t i = 0; i < rows.size(); i += ratios) {
    if (rows[i].point.factor != factor) continue;
    std::vector<std::string> means{rows[i].point.value,
                                   rows[i].point.centre ? "as in the grid" : ""};
    std::vector<std::string> intervals{"", "95 %"};
    for (std::size_t j = i; j < i + ratios; ++j) {
      means.push_back(mean_label(rows[j].summary));
      intervals.push_back(interval_label(rows[j].summary));
    }
    table.row(means);
    if (rows[i].summary.interval) table.row(intervals);
  }
  return table;
}

}  // namespace

std::string SweepPoint::folder() const {
  return centre ? paper_method() : "sweep/" + factor + "-" + value;
}

void bind(const cli::Options& command, SweepOptions& options) {
  command.add("--dataset", options.dataset, "Dataset, such as cwru").required();
  command.add("--points", options.points, "Settings tried, such as: batch=1 batch=5 depth=2")
      .required();
  command.add("--centre", options.centre, "Those of them that are the method as the grid has it");
  command.add("--ratios", options.ratios, "Ratios, such as: 10to1 1to1").required();
  command.add("--seeds", options.seeds, "Seeds, such as: 0 1 2").required();
}

Sweep resolve(const SweepOptions& options) {
  Sweep sweep;
  sweep.grid =
      resolve(run::GridOptions{options.dataset, {paper_method()}, options.ratios, options.seeds});
  const std::vector<std::string> words = run::split_list("--points", options.points);
  std::vector<std::string> centre;
  if (!options.centre.empty()) centre = run::split_list("--centre", options.centre);
  for (const std::string& word : centre) {
    if (std::ranges::find(words, word) == words.end()) {
      throw Error(Exit::usage, "--centre: '" + word + "' is none of --points");
    }
  }
  for (const std::string& word : words) sweep.points.push_back(parse_point(word, centre));
  return sweep;
}

std::vector<SweepRow> sweep_rows(const run::Layout& layout, const Sweep& sweep,
                                 run::Results& results) {
  std::vector<SweepRow> rows;
  for (const SweepPoint& point : sweep.points) {
    for (const run::Combination& combination : sweep.grid.combinations) {
      if (const auto row = row_of(layout, sweep, point, combination, results)) rows.push_back(*row);
    }
  }
  return rows;
}

std::string sweep_csv(const Sweep& sweep, const std::vector<SweepRow>& rows) {
  std::string text = text::csv_line(
      {"dataset", "factor", "value", "ratio", "seeds", "mean", "std", "ci95_low", "ci95_high"});
  for (const SweepRow& row : rows) {
    text += joined_csv_line({{sweep.grid.dataset, row.point.factor, row.point.value, row.ratio,
                              std::to_string(row.summary.count)},
                             mean_fields(row.summary),
                             interval_fields(row.summary)});
  }
  return text;
}

Document sweep_document(const Sweep& sweep, const std::vector<SweepRow>& rows,
                        const run::Results& results) {
  Document document{.key = sweep.grid.dataset + "-sweep",
                    .title = "Settings of " + paper_method() + " on " + sweep.grid.dataset};
  const std::size_t seeds = sweep.grid.seeds.size();
  document.paragraphs.push_back(fmt::format(
      "Accuracy in percent where one setting is moved and all others are those of the grid (paper, "
      "Section 4.5.5 and Fig. 19, which publishes no numbers). Split protocol {}; {} seed{}. "
      "Numbers are the mean ± the sample standard deviation over the seeds; 95 % is the interval "
      "of the mean by Student's t.",
      to_string(results.diagnoses.front().protocol), seeds, seeds == 1 ? "" : "s"));
  for (const std::string& factor : factors_of(sweep)) {
    document.sections.push_back({factor, "By " + factor, "", factor_table(factor, sweep, rows)});
  }
  return document;
}

}  // namespace piae::report
