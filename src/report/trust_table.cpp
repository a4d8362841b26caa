#include "report/trust_table.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <map>

#include "report/columns.hpp"
#include "report/labels.hpp"

namespace piae::report {

namespace {

void require_of_cell(const artefact::Reader& reader, const diagnosis::KeptClassifier& kept,
                     const run::Grid& grid, const run::Combination& combination,
                     std::int64_t seed) {
  const diagnosis::ClassifierOrigin& origin = kept.origin();
  if (kept.info().name == grid.dataset && origin.method == combination.method &&
      origin.ratio == combination.ratio && origin.seed == seed &&
      kept.classifier().name == combination.classifier) {
    return;
  }
  reader.refuse("/", fmt::format("is {} of {}, {} {}, seed {}; here it must be {} of {}, {} {}, "
                                 "seed {}",
                                 kept.classifier().name, kept.info().name, origin.method,
                                 origin.ratio, origin.seed, combination.classifier, grid.dataset,
                                 combination.method, combination.ratio, seed));
}

/// Returns the mean over the seeds of a share, in percent.
scoring::Summary percent_over_seeds(const std::vector<diagnosis::Trust>& trusts,
                                    double diagnosis::Trust::*share) {
  std::vector<double> values;
  for (const diagnosis::Trust& trust : trusts) values.push_back(100 * trust.*share);
  return scoring::summarise(values);
}

/// Adds the numbers for classes left out of training, if the classifier measures novelty.
void add_untrained(TrustRow& row, const std::vector<diagnosis::Trust>& trusts,
                   const std::map<Label, std::string>& names) {
  std::vector<double> aurocs;
  std::vector<double> unknown;
  std::map<Label, std::vector<double>> by_class;
  for (const diagnosis::Trust& trust : trusts) {
    if (trust.untrained.empty()) continue;
    const auto classes = static_cast<double>(trust.untrained.size());
    double auroc = 0;
    double called_unknown = 0;
    for (const auto& [label, of_class] : trust.untrained) {
      by_class[label].push_back(of_class.auroc);
      auroc += of_class.auroc / classes;
      called_unknown += 100 * of_class.called_unknown / classes;
    }
    aurocs.push_back(auroc);
    unknown.push_back(called_unknown);
  }
  if (aurocs.empty()) return;
  row.auroc = scoring::summarise(aurocs);
  row.untrained_called_unknown = scoring::summarise(unknown);
  for (const auto& [label, values] : by_class) {
    row.auroc_by_class.emplace_back(names.at(label), scoring::summarise(values));
  }
}

TrustRow trust_row(const run::Layout& layout, const run::Grid& grid,
                   const run::Combination& combination) {
  using diagnosis::Trust;
  std::vector<Trust> trusts;
  std::vector<double> temperatures;
  std::map<Label, std::string> names;
  for (const std::int64_t seed : grid.seeds) {
    const artefact::Reader reader(
        layout.kept_classifier(combination.method, combination.ratio, seed, combination.classifier),
        "classifier");
    const diagnosis::KeptClassifier kept(reader);
    require_of_cell(reader, kept, grid, combination, seed);
    trusts.push_back(diagnosis::read_trust(reader, kept.info()));
    temperatures.push_back(kept.calibration().temperature);
    for (const Label label : kept.info().fault_labels()) {
      names[label] = kept.info().class_of(label).name;
    }
  }
  TrustRow row{.combination = combination,
               .accuracy = percent_over_seeds(trusts, &Trust::accuracy),
               .raw_calibration_error = percent_over_seeds(trusts, &Trust::raw_calibration_error),
               .calibration_error = percent_over_seeds(trusts, &Trust::calibration_error),
               .called_unknown = percent_over_seeds(trusts, &Trust::called_unknown),
               .temperature = scoring::summarise(temperatures)};
  add_untrained(row, trusts, names);
  return row;
}

std::string name_of_row(const TrustRow& row) {
  return run::name_by(method_label(row.combination.method), row.combination.classifier);
}

Section calibration_section(const std::vector<TrustRow>& rows) {
  using Row = TrustRow;
  const auto percent = [](scoring::Summary Row::*summary) {
    return [summary](const Row& row) { return mean_cell(row.*summary, percent_style); };
  };
  Columns<Row> columns;
  columns.words("method", name_of_row)
      .words("ratio", [](const Row& row) { return short_ratio_label(row.combination.ratio); })
      .numbers("accuracy", percent(&Row::accuracy))
      .numbers("error as is", percent(&Row::raw_calibration_error))
      .numbers("calibrated", percent(&Row::calibration_error))
      .numbers("temperature", [](const Row& row) { return mean_cell(row.temperature); });
  return {.key = "calibration",
          .title = "How sure a classifier says it is, and how often it is right, percent",
          .note =
              "Expected calibration error over ten bins of the test windows (Guo et al. 2017): "
              "by the softmax as it is, and with the temperature, which was found on windows left "
              "out of separate trainings, none of which is tested.",
          .table = columns.table(rows)};
}

Section unknown_section(const std::vector<TrustRow>& rows) {
  text::Table table({"method", "ratio", "called unknown", "untrained: area", "untrained: unknown"},
                    2);
  for (const TrustRow& row : rows) {
    text::Cells cells{name_of_row(row), short_ratio_label(row.combination.ratio), no_number,
                      no_number, no_number};
    if (row.auroc) {
      cells[2] = mean_cell(row.called_unknown, percent_style);
      cells[3] = mean_cell(*row.auroc, {.decimals = 3});
      cells[4] = mean_cell(*row.untrained_called_unknown, percent_style);
    }
    table.row(std::move(cells));
  }
  return {.key = "unknown",
          .title = "Windows that look like nothing that was trained",
          .note =
              "Percent of the test windows that are called unknown although their classes were "
              "trained. Then, with one fault class at a time left out of the training: the area "
              "under the receiver operating characteristic of its windows against the others, and "
              "the percent of its windows that are called unknown, averaged over the classes.",
          .table = table};
}

/// True if an earlier row has the same areas, as when both compare with the same windows.
bool is_as_before(const std::vector<TrustRow>& rows, std::size_t row) {
  return std::any_of(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(row),
                     [&](const TrustRow& earlier) {
                       return std::ranges::equal(
                           earlier.auroc_by_class, rows[row].auroc_by_class, {},
                           [](const auto& c) { return c.second.mean; },
                           [](const auto& c) { return c.second.mean; });
                     });
}

Section class_section(const std::vector<TrustRow>& rows) {
  text::Table table({"class not trained", "method", "ratio", "area"}, 3);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (is_as_before(rows, i)) continue;
    for (const auto& [name, auroc] : rows[i].auroc_by_class) {
      table.row({name, name_of_row(rows[i]), short_ratio_label(rows[i].combination.ratio),
                 mean_label(auroc, {.decimals = 3})});
    }
  }
  return {.key = "unknown-classes",
          .title = "The same, class by class",
          .note =
              "The comparison uses the real windows of the training set. A method with the same "
              "real windows and areas as one above is not shown again.",
          .table = table};
}

}  // namespace

std::vector<TrustRow> trust_rows(const run::Layout& layout, const run::Grid& grid) {
  std::vector<TrustRow> rows;
  for (const run::Combination& combination : grid.combinations) {
    rows.push_back(trust_row(layout, grid, combination));
  }
  return rows;
}

std::string trust_csv(const std::string& dataset, const std::vector<TrustRow>& rows) {
  struct Line {
    const run::Combination* of;
    std::string quantity;
    std::string class_name;
    scoring::Summary summary;
  };
  std::vector<Line> lines;
  for (const TrustRow& row : rows) {
    const auto add = [&](const std::string& quantity, const scoring::Summary& summary,
                         const std::string& class_name = "") {
      lines.push_back({&row.combination, quantity, class_name, summary});
    };
    add("accuracy", row.accuracy);
    add("raw_calibration_error", row.raw_calibration_error);
    add("calibration_error", row.calibration_error);
    add("temperature", row.temperature);
    add("called_unknown", row.called_unknown);
    if (row.auroc) add("untrained_auroc", *row.auroc);
    if (row.auroc) add("untrained_called_unknown", *row.untrained_called_unknown);
    for (const auto& [name, auroc] : row.auroc_by_class) add("untrained_auroc", auroc, name);
  }
  Columns<Line> columns;
  columns.field("dataset", [&](const Line&) { return dataset; })
      .field("classifier", [](const Line& line) { return line.of->classifier; })
      .field("method", [](const Line& line) { return line.of->method; })
      .field("ratio", [](const Line& line) { return line.of->ratio; })
      .field("seeds", [](const Line& line) { return count_cell(line.summary.count); })
      .field("quantity", &Line::quantity)
      .field("class", &Line::class_name)
      .summary_fields("mean", "", &Line::summary, false);
  return columns.table(lines).csv();
}

Document trust_document(const std::string& dataset, const std::vector<TrustRow>& rows) {
  return {.key = dataset + "-trust",
          .title = dataset + ": how far kept classifiers are to be believed",
          .paragraphs = {"Kept classifiers on the test windows A. Means and "
                         "standard deviations over the seeds."},
          .sections = {calibration_section(rows), unknown_section(rows), class_section(rows)}};
}

}  // namespace piae::report
