#include "report/identifiability.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "base/error.hpp"
#include "report/columns.hpp"
#include "report/gaps.hpp"
#include "report/labels.hpp"
#include "scoring/identifiability.hpp"
#include "text/csv.hpp"

namespace piae::report {

namespace {

/// Words and unit of k or c in tables.
struct Parameter {
  const char* name;
  double signal::DynamicParameters::*value;
  double unit;          ///< divisor of the values in tables, in N/m or N s/m
  const char* heading;  ///< with the unit
};
constexpr std::array<Parameter, 2> parameters{{
    {"stiffness", &signal::DynamicParameters::stiffness_n_per_m, 1e6, "stiffness, MN/m"},
    {"damping", &signal::DynamicParameters::damping_ns_per_m, 1, "damping, N s/m"},
}};

/// True and inferred values of one parameter, in the same order.
struct Values {
  std::vector<double> truth;
  std::vector<double> inferred;

  /// Adds the windows of one class, or all windows if `label` is empty.
  void add(const Identification& one, const Parameter& parameter, std::optional<Label> label) {
    for (std::size_t i = 0; i < one.windows.size(); ++i) {
      if (label && one.windows.labels[i] != *label) continue;
      truth.push_back(one.windows.parameters[i].*parameter.value);
      inferred.push_back(one.inferred[i].*parameter.value);
    }
  }
};

std::vector<std::string> identified_methods(const std::vector<Identification>& all) {
  std::vector<std::string> methods;
  for (const Identification& one : all) {
    if (std::ranges::find(methods, one.method) == methods.end()) methods.push_back(one.method);
  }
  return methods;
}

void require_truth(const Identification& one) {
  if (one.windows.parameters.size() == one.windows.size()) return;
  throw Error(Exit::bad_input,
              fmt::format("{}: the true stiffness and damping of its windows are not known; name a "
                          "data set that `simulate` makes, such as simulated",
                          one.windows.info.name));
}

IdentifiabilityRow identifiability_row(const std::vector<Identification>& all,
                                       const std::string& method, const Parameter& parameter,
                                       const std::string& class_name, std::optional<Label> label) {
  std::vector<double> r2;
  std::vector<double> bias;
  std::vector<double> correlation2;
  for (const Identification& one : all) {
    if (one.method != method) continue;
    Values values;
    values.add(one, parameter, label);
    const auto [low, high] = std::ranges::minmax(values.truth);
    if (!(low < high)) {
      throw Error(Exit::bad_input,
                  fmt::format("{}, seed {}: the true {} of class {} does not vary, so how well it "
                              "is inferred cannot be measured",
                              one.windows.info.name, one.seed, parameter.name, class_name));
    }
    const scoring::Agreement found = scoring::agreement(values.truth, values.inferred);
    r2.push_back(found.r2);
    bias.push_back(found.bias);
    correlation2.push_back(found.correlation2);
  }
  return {.method = method,
          .parameter = parameter.name,
          .class_name = class_name,
          .r2 = scoring::summarise(r2),
          .bias = scoring::summarise(bias),
          .correlation2 = scoring::summarise(correlation2)};
}

/// For people, each method and parameter is named in its first line only.
text::Table agreement_table(const std::string& dataset,
                            const std::vector<IdentifiabilityRow>& rows) {
  using Row = IdentifiabilityRow;
  const auto name = [](const std::string& text, bool is_first) {
    text::Cell cell = is_first ? text : "";
    cell.field = text;
    return cell;
  };
  const auto is_first = [](const Row& row) { return row.class_name == "all"; };
  Columns<Row> columns;
  columns.field("dataset", [&](const Row&) { return dataset; })
      .words(
          "method",
          [=](const Row& row) {
            return name(row.method, is_first(row) && row.parameter == parameters.front().name);
          },
          "method")
      .words(
          "parameter", [=](const Row& row) { return name(row.parameter, is_first(row)); },
          "parameter")
      .words("class", &Row::class_name, "class")
      .field("seeds", [](const Row& row) { return count_cell(row.r2.count); })
      .summary_fields("r2_mean", "r2_", &Row::r2, false)
      .summary_fields("bias_mean", "bias_", &Row::bias, false)
      .summary_fields("correlation2_mean", "correlation2_", &Row::correlation2, false)
      .numbers("R²", [](const Row& row) { return mean_cell(row.r2, {.decimals = 3}); })
      .numbers("bias, %",
               [](const Row& row) {
                 scoring::Summary percent = row.bias;
                 percent.mean *= 100;
                 if (percent.deviation) *percent.deviation *= 100;
                 return mean_cell(percent, {.decimals = 1, .sign = true});
               })
      .numbers("correlation²",
               [](const Row& row) { return mean_cell(row.correlation2, {.decimals = 3}); });
  return columns.table(rows);
}

/// Returns the scatter of one parameter over the windows of all seeds together.
std::vector<scoring::ScatterRow> scatter_of(const std::vector<Identification>& all,
                                            const std::string& method, const Parameter& parameter) {
  constexpr std::size_t groups = 10;
  Values values;
  for (const Identification& one : all) {
    if (one.method == method) values.add(one, parameter, std::nullopt);
  }
  return scoring::scatter(values.truth, values.inferred, groups);
}

Section scatter_section(const std::vector<Identification>& all, const Parameter& parameter) {
  text::Table table({"method", "true from", "to", "windows", "inferred 10 %", "50 %", "90 %"}, 1);
  for (const std::string& method : identified_methods(all)) {
    std::string name = method;
    for (const scoring::ScatterRow& row : scatter_of(all, method, parameter)) {
      const auto in_unit = [&](double value) { return number_label(value / parameter.unit); };
      table.row({name, in_unit(row.truth_low), in_unit(row.truth_high), std::to_string(row.count),
                 in_unit(row.inferred_p10), in_unit(row.inferred_p50), in_unit(row.inferred_p90)});
      name.clear();
    }
  }
  return {std::string("scatter-") + parameter.name, std::string("Scatter of ") + parameter.heading,
          "Windows of all seeds in groups of equal count by their true value; for each group the "
          "median of the inferred values, and the range that holds 80 % of them.",
          table};
}

/// Returns "10 seeds (0 to 9)" or, if methods differ, "piae-dt: 10 seeds (0 to 9), ae: 1 seed (3)".
std::string models_label(const std::vector<Identification>& all) {
  std::map<std::string, std::string> by_method;
  std::set<std::string> labels;
  for (const std::string& method : identified_methods(all)) {
    std::vector<std::int64_t> seeds;
    for (const Identification& one : all) {
      if (one.method == method) seeds.push_back(one.seed);
    }
    by_method[method] = fmt::format("{} ({})", counted(seeds.size(), "seed"), seed_list(seeds));
    labels.insert(by_method[method]);
  }
  if (labels.size() == 1) return *labels.begin();
  std::string label;
  for (const std::string& method : identified_methods(all)) {
    label += (label.empty() ? "" : ", ") + method + ": " + by_method[method];
  }
  return label;
}

}  // namespace

void bind(const cli::Options& command, IdentifiabilityOptions& options) {
  command.add("--dataset", options.dataset, "Data set whose (k, c) are known: simulated")
      .required();
  command.add("--methods", options.methods, "Methods that infer (k, c), such as: piae-dt")
      .required();
  command.add("--seeds", options.seeds, "Seeds, such as: 0 1 2").required();
}

run::Grid resolve(const IdentifiabilityOptions& options) {
  // Any ratio will do: the same model serves all ratios.
  return resolve(run::GridOptions{options.dataset, options.methods, {"1to1"}, options.seeds});
}

std::vector<IdentifiabilityRow> identifiability_rows(const std::vector<Identification>& all) {
  std::ranges::for_each(all, require_truth);
  std::vector<IdentifiabilityRow> rows;
  for (const std::string& method : identified_methods(all)) {
    for (const Parameter& parameter : parameters) {
      rows.push_back(identifiability_row(all, method, parameter, "all", std::nullopt));
      const signal::DatasetInfo& info = all.front().windows.info;
      for (const Label label : info.fault_labels()) {
        rows.push_back(
            identifiability_row(all, method, parameter, info.class_of(label).name, label));
      }
    }
  }
  return rows;
}

std::string identifiability_csv(const std::string& dataset,
                                const std::vector<IdentifiabilityRow>& rows) {
  return agreement_table(dataset, rows).csv();
}

std::string scatter_csv(const std::string& dataset, const std::vector<Identification>& all) {
  std::string text = text::csv_line({"dataset", "method", "parameter", "truth_low", "truth_high",
                                     "windows", "inferred_p10", "inferred_p50", "inferred_p90"});
  for (const std::string& method : identified_methods(all)) {
    for (const Parameter& parameter : parameters) {
      for (const scoring::ScatterRow& row : scatter_of(all, method, parameter)) {
        text += text::csv_line(
            {dataset, method, parameter.name, fmt::format("{:.6g}", row.truth_low),
             fmt::format("{:.6g}", row.truth_high), std::to_string(row.count),
             fmt::format("{:.6g}", row.inferred_p10), fmt::format("{:.6g}", row.inferred_p50),
             fmt::format("{:.6g}", row.inferred_p90)});
      }
    }
  }
  return text;
}

Document identifiability_document(const std::string& dataset,
                                  const std::vector<IdentifiabilityRow>& rows,
                                  const std::vector<Identification>& all) {
  Document document{.key = dataset + "-identifiability",
                    .title = "How well stiffness and damping are identified on " + dataset};
  document.paragraphs.push_back(fmt::format(
      "Each method learns from the known windows C only and infers (k, c) of the real windows D, "
      "which it has not seen. Both are simulated, so the true values are known (Sections 3.2 and "
      "3.3 of the paper claim that the learned features are these parameters). {}.",
      models_label(all)));
  document.sections.push_back(
      {"agreement", "Agreement of the inferred with the true parameters",
       "R² is 1 if both are equal, 0 if the true mean would be as good an estimate, and negative "
       "if it would be a better one. Correlation² is the R² of the best linear calibration of the "
       "inferred values. Mean ± sample standard deviation over the seeds.",
       agreement_table(dataset, rows)});
  for (const Parameter& parameter : parameters) {
    document.sections.push_back(scatter_section(all, parameter));
  }
  return document;
}

}  // namespace piae::report
