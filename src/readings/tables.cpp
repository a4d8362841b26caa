#include "readings/tables.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <map>

#include "augment/catalogue.hpp"
#include "report/gaps.hpp"
#include "report/labels.hpp"
#include "text/csv.hpp"

namespace piae::readings {

namespace {

using report::Section;
using text::Table;

const std::string as_published = "published";

/// A column of a table: heading, quantity and number format.
struct Column {
  std::string heading;
  std::string quantity;
  std::string ratio = {};
  int decimals = 2;
  double unit = 1;  ///< divisor of the numbers
};

const Row* find(const std::vector<Row>& rows, const std::string& reading, const Column& column) {
  const auto row = std::ranges::find_if(rows, [&](const Row& each) {
    return each.reading == reading && each.quantity == column.quantity &&
           each.ratio == column.ratio;
  });
  return row == rows.end() ? nullptr : &*row;
}

std::string cell_of(const Row* row, const Column& column) {
  if (row == nullptr) return report::no_number;
  scoring::Summary scaled = row->summary;
  scaled.mean /= column.unit;
  if (scaled.deviation) *scaled.deviation /= column.unit;
  return report::mean_label(scaled, {.decimals = column.decimals});
}

void add_row(Table& table, const std::string& label, const std::string& reading,
             const std::vector<Row>& rows, const std::vector<Column>& columns) {
  std::vector<std::string> cells{label};
  for (const Column& column : columns)
    cells.push_back(cell_of(find(rows, reading, column), column));
  table.row(cells);
}

Table table_of(const Readings& readings, const std::vector<Row>& rows,
               const std::vector<Column>& columns) {
  std::vector<std::string> header{"reading"};
  for (const Column& column : columns) header.push_back(column.heading);
  Table table(header, 1);
  for (const Reading& reading : readings.readings) {
    add_row(table, reading.name, reading.name, rows, columns);
  }
  return table;
}

Section accuracy_section(const Readings& readings, const std::vector<Row>& rows) {
  std::vector<Column> columns;
  for (const run::Combination& cell : readings.grid.combinations) {
    const std::string ratio = report::short_ratio_label(cell.ratio);
    columns.push_back(
        {.heading = ratio, .quantity = "accuracy", .ratio = cell.ratio, .decimals = 1});
    columns.push_back(
        {.heading = ratio + " nearest", .quantity = "nearest", .ratio = cell.ratio, .decimals = 1});
  }
  Table table = table_of(readings, rows, columns);
  if (std::ranges::count(rows, as_published, &Row::reading) > 0) {
    add_row(table, "as published", as_published, rows, columns);
  }
  return {"accuracy", "Accuracy in percent",
          "WDCNN on the waveform, and the nearest neighbour in 128 bands of the spectrum, which "
          "does not need training.",
          table};
}

Section quality_section(const Readings& readings, const std::vector<Row>& rows) {
  return {
      "quality", "The generated windows next to real ones",
      "Means over the classes. Real windows have an amplitude ratio of 1.",
      table_of(readings, rows,
               {{.heading = "MMD²", .quantity = "mmd", .decimals = 3},
                {.heading = "RMSE", .quantity = "rmse", .decimals = 3},
                {.heading = "amplitude", .quantity = "amplitude_ratio"},
                {.heading = "spectrum, dB", .quantity = "spectral_distance_db", .decimals = 1}})};
}

Section losses_section(const Readings& readings, const std::vector<Row>& rows) {
  return {"losses", "Losses at the end, and their weights",
          "Losses are means of the last epoch. The column after each weight of eq. 23 is the "
          "weight divided by its stationary point 1 / (2 L): 1 means that it is reached.",
          table_of(readings, rows,
                   {{.heading = "L_DDL", .quantity = "L_DDL", .decimals = 3},
                    {.heading = "L_DT", .quantity = "L_DT", .decimals = 3},
                    {.heading = "L_Rec", .quantity = "L_Rec", .decimals = 3},
                    {.heading = "α", .quantity = "alpha"},
                    {.heading = "2αL", .quantity = "alpha_of_stationary"},
                    {.heading = "β", .quantity = "beta"},
                    {.heading = "2βL", .quantity = "beta_of_stationary"},
                    {.heading = "γ", .quantity = "gamma"},
                    {.heading = "2γL", .quantity = "gamma_of_stationary"}})};
}

Section states_section(const Readings& readings, const std::vector<Row>& rows) {
  return {
      "states", "Stiffness and damping",
      "Known windows: the percentage with an open contact at rest, and with a damping below the "
      "paper's 10 N s/m (3.3.1); the mean of k in MN/m and of c in N s/m, and their standard "
      "deviation as a fraction of the mean; the fraction of their variance that lies between the "
      "classes, which is 0.18 by chance for nine classes of five. R² and bias compare with the "
      "true values of windows that the model has not seen, where these are known.",
      table_of(readings, rows,
               {{.heading = "open, %", .quantity = "open_contacts", .decimals = 0},
                {.heading = "low c, %", .quantity = "low_damping", .decimals = 0},
                {.heading = "k", .quantity = "stiffness", .decimals = 0, .unit = 1e6},
                {.heading = "its spread", .quantity = "stiffness_spread"},
                {.heading = "classes", .quantity = "stiffness_between_classes"},
                {.heading = "c", .quantity = "damping", .decimals = 1},
                {.heading = "its spread", .quantity = "damping_spread"},
                {.heading = "classes", .quantity = "damping_between_classes"},
                {.heading = "R² of k", .quantity = "stiffness_r2"},
                {.heading = "bias of k", .quantity = "stiffness_bias"},
                {.heading = "R² of c", .quantity = "damping_r2"},
                {.heading = "bias of c", .quantity = "damping_bias"}})};
}

}  // namespace

std::vector<Row> rows_of(const Reading& reading,
                         const std::vector<std::vector<Measured>>& by_seed) {
  std::vector<Row> rows;
  for (const Measured& first : by_seed.front()) {
    std::vector<double> values;
    for (const std::vector<Measured>& measured : by_seed) {
      for (const Measured& each : measured) {
        if (each.quantity == first.quantity && each.ratio == first.ratio) {
          values.push_back(each.value);
        }
      }
    }
    rows.push_back({.reading = reading.name,
                    .quantity = first.quantity,
                    .ratio = first.ratio,
                    .summary = scoring::summarise(values)});
  }
  return rows;
}

std::vector<Row> published_rows(const run::Grid& grid, const report::Published& published) {
  std::vector<Row> rows;
  for (const run::Combination& cell : grid.combinations) {
    const auto percent = published.percent(grid.dataset, cell.method, cell.ratio);
    if (!percent) continue;
    rows.push_back({.reading = as_published,
                    .quantity = "accuracy",
                    .ratio = cell.ratio,
                    .summary = scoring::summarise(std::vector<double>{*percent})});
  }
  return rows;
}

std::string csv(const std::string& dataset, const std::vector<Row>& rows) {
  std::string text =
      text::csv_line({"dataset", "reading", "quantity", "ratio", "seeds", "mean", "std"});
  for (const Row& row : rows) {
    const scoring::Summary& s = row.summary;
    text += text::csv_line({dataset, row.reading, row.quantity, row.ratio, std::to_string(s.count),
                            fmt::format("{:.6g}", s.mean),
                            s.deviation ? fmt::format("{:.6g}", *s.deviation) : ""});
  }
  return text;
}

report::Document document(const Readings& readings, const std::vector<Row>& rows) {
  const auto& seeds = readings.grid.seeds;
  report::Document document{.key = readings.grid.dataset + "-readings",
                            .title = "Readings of the paper on " + readings.grid.dataset};
  document.paragraphs.push_back(
      fmt::format("Interpretations of {} where the paper leaves a choice (pipeline/protocol.toml, "
                  "[readings]). The name of each gives its difference from base; base is {}. Mean "
                  "± sample standard deviation "
                  "over {} seed{} "
                  "({}).",
                  augment::paper_method(), fmt::join(readings.base, ", "), seeds.size(),
                  seeds.size() == 1 ? "" : "s", report::seed_list(seeds)));
  document.sections.push_back(accuracy_section(readings, rows));
  document.sections.push_back(quality_section(readings, rows));
  document.sections.push_back(losses_section(readings, rows));
  document.sections.push_back(states_section(readings, rows));
  return document;
}

}  // namespace piae::readings
