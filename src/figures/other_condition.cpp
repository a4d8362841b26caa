#include "figures/other_condition.hpp"

#include <algorithm>
#include <cmath>

#include "augment/catalogue.hpp"
#include "base/columns.hpp"
#include "base/parallel.hpp"
#include "bearing/impact_frequency.hpp"
#include "figures/line_name.hpp"
#include "figures/stored_windows.hpp"
#include "figures/view_rows.hpp"

namespace piae::figures {

namespace {

using Eigen::Index;
using signal::DatasetInfo;
using signal::WindowSet;

/// The method that uses neither bearings nor conditions.
const std::string knows_nothing = "shift";

constexpr int most_harmonics = 12;

struct NamedWindows {
  std::string name;
  WindowSet windows;
};

/// All windows behind the pictures.
struct ConditionSets {
  WindowSet known;
  WindowSet real;
  std::vector<NamedWindows> generated;
};

/// Windows of one class and one condition.
struct ConditionRow {
  std::string name;
  std::string condition;  ///< its name; empty if windows do not record it
  double rpm = 0;
  scoring::Windows windows;
};

/// Orders the rows: `shift` first, then the other controls. The remaining methods are next to the
/// real windows.
int place_among_rows(const NamedWindows& generated) {
  if (generated.name == knows_nothing) return 0;
  const augment::CatalogueEntry* const entry = augment::find_entry(generated.name);
  return entry != nullptr && entry->kind == augment::Kind::control ? 1 : 2;
}

ConditionSets read_sets(const Source& source) {
  const run::Layout& layout = source.layout();
  WindowSet real = read_windows(layout.real_windows(source.shown_seed()), signal::Role::hidden);
  if (!signal::is_transfer(real.info.conditions)) {
    throw LeftOut(real.info.name +
                  " has no [transfer]: faults are tested in the condition that they are known in");
  }
  WindowSet known =
      read_windows_with(real, layout.known_windows(source.shown_seed()), signal::Role::known);
  std::vector<NamedWindows> generated;
  for (const std::string& method : source.grid().scored) {
    auto windows = read_generated(source, method, real);
    if (!windows || (windows->condition.empty() && method != knows_nothing)) continue;
    generated.push_back({method, std::move(*windows)});
  }
  std::ranges::stable_sort(generated, {}, place_among_rows);
  return {std::move(known), std::move(real), std::move(generated)};
}

double fastest_rpm(const DatasetInfo& info) {
  double fastest = 0;
  for (const signal::Condition& condition : info.conditions) {
    if (condition.known || condition.test) fastest = std::max(fastest, condition.shaft_speed_rpm);
  }
  return fastest;
}

/// Returns the windows of a class in a condition; all of them if windows do not record theirs.
scoring::Windows windows_in(std::int32_t condition, const WindowSet& set, Label label) {
  const std::vector<std::size_t> own = set.indices_of(label);
  std::vector<Index> in_condition;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const bool is_in = set.condition.empty() || set.condition[own[i]] == condition ||
                       set.condition[own[i]] == signal::every_condition;
    if (is_in) in_condition.push_back(static_cast<Index>(i));
  }
  const scoring::Windows windows = scoring::windows_of(set, label, own.size());
  return windows(in_condition, every_column(windows));
}

/// Returns the tested condition with real windows of the class whose speed is farthest from the
/// known one.
std::int32_t shown_condition(const WindowSet& real, Label label) {
  std::vector<std::int32_t> tested = real.info.tested_conditions();
  std::erase_if(tested, [&](std::int32_t i) { return windows_in(i, real, label).rows() == 0; });
  return *std::ranges::max_element(tested, {}, [&](std::int32_t i) {
    return std::abs(std::log(real.info.speed_rpm(i) / real.info.known_speed_rpm()));
  });
}

/// Adds a row, unless the set has no windows of the class in this condition, because few are known
/// or generated.
void add_condition(std::vector<ConditionRow>& rows, const std::string& name, const WindowSet& set,
                   Label label, std::int32_t condition) {
  scoring::Windows windows = windows_in(condition, set, label);
  if (windows.rows() == 0) return;
  const signal::Condition& of_row = set.info.conditions[static_cast<std::size_t>(condition)];
  rows.push_back(
      {name, set.condition.empty() ? "" : of_row.name, of_row.shaft_speed_rpm, std::move(windows)});
}

std::vector<ConditionRow> rows_of_class(const ConditionSets& sets, Label label) {
  std::vector<ConditionRow> rows;
  for (const std::int32_t condition : sets.real.info.known_conditions()) {
    const std::string number = rows.empty() ? "" : "-" + std::to_string(rows.size() + 1);
    add_condition(rows, "known" + number, sets.known, label, condition);
  }
  const std::int32_t tested = shown_condition(sets.real, label);
  for (const NamedWindows& each : sets.generated) {
    add_condition(rows, each.name, each.windows, label, tested);
  }
  add_condition(rows, "real", sets.real, label, tested);
  return rows;
}

/// Returns each window without its mean and with an RMS of 1.
scoring::Windows standardised(const scoring::Windows& windows) {
  scoring::Windows result = windows.colwise() - windows.rowwise().mean();
  const double root_of_length = std::sqrt(static_cast<double>(windows.cols()));
  for (Index i = 0; i < result.rows(); ++i) result.row(i) *= root_of_length / result.row(i).norm();
  return result;
}

std::vector<NamedView> views_of_rows(const std::vector<ConditionRow>& rows, const ViewAxes& axes) {
  std::vector<NamedView> views(rows.size());
  parallel_for(rows.size(), [&](std::size_t i) {
    const scoring::Windows& windows = rows[i].windows;
    views[i] = {rows[i].name, view_of(standardised(windows), typical_window(windows), axes)};
  });
  return views;
}

/// Adds the lines of a defect in each row, up to the end of the axis.
void add_lines_of_rows(ViewRows& numbers, const std::vector<ConditionRow>& rows,
                       const DatasetInfo& info, signal::Defect defect, double last_hz) {
  if (!bearing::causes_impacts(defect)) return;
  for (int harmonic = 1; harmonic <= most_harmonics; ++harmonic) {
    std::vector<std::string> lines;
    for (const ConditionRow& row : rows) {
      const double hz = harmonic * bearing::impact_frequency_hz(info.bearing, defect, row.rpm);
      lines.push_back(hz > last_hz ? "" : few_digits(hz));
    }
    if (std::ranges::all_of(lines, &std::string::empty)) return;
    numbers.row("line", line_name(defect), "", std::to_string(harmonic), lines);
  }
}

Numbers numbers_of_rows(const std::vector<ConditionRow>& rows, const DatasetInfo& info,
                        signal::Defect defect, const ViewAxes& axes) {
  ViewRows numbers(views_of_rows(rows, axes), axes);
  for (const ConditionRow& row : rows)
    numbers.row("row", row.name, few_digits(row.rpm), row.condition);
  numbers.waveforms();
  numbers.spectra();
  add_lines_of_rows(numbers, rows, info, defect,
                    axes.envelope_hz(axes.envelope_bins().groups() - 1));
  return numbers.numbers();
}

}  // namespace

std::vector<Picture> other_condition(Source& source) {
  const ConditionSets sets = read_sets(source);
  const DatasetInfo& info = sets.real.info;
  const ViewAxes axes(info, static_cast<Index>(sets.real.length), fastest_rpm(info));
  std::vector<Picture> pictures;
  for (const Label label : info.fault_labels()) {
    const signal::ClassInfo& of_class = info.class_of(label);
    const std::vector<ConditionRow> rows = rows_of_class(sets, label);
    pictures.push_back({of_class.name, numbers_of_rows(rows, info, of_class.defect, axes)});
  }
  return pictures;
}

}  // namespace piae::figures
