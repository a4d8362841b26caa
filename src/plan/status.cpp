#include "plan/status.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "plan/goals.hpp"
#include "plan/words.hpp"

namespace piae::plan {

namespace {

const std::string shared = "records, split";

/// Counts of one line of the table.
struct Row {
  std::string dataset;
  std::string unit;
  std::array<std::size_t, 4> cells{};  ///< by progress
  double seconds_left = 0;
  bool any_unknown = false;

  [[nodiscard]] std::size_t all() const { return cells[0] + cells[1] + cells[2] + cells[3]; }
};

/// Durations of the steps of a run, by similarity.
class Durations {
 public:
  Durations(Plan& plan, Logs& logs) {
    constexpr std::size_t enough = 20;  // for a reliable mean
    // Steps that the run holds without a request count, too.
    for (StepId id = 0; id < plan.graph().steps().size(); ++id) {
      const Step& step = plan.graph().at(id);
      if (!step.is_artefact || plan.judge().of(id).state != State::current) continue;
      if (taken_[keys_of(step).front()].count >= enough) continue;
      const auto log = logs.read(log_of(step));
      if (!log || log->end != run::StepEnd::done) continue;
      for (const std::string& key : keys_of(step)) {
        taken_[key].seconds += log->elapsed_s;
        ++taken_[key].count;
      }
    }
  }

  /// Returns the expected seconds of a step; empty if no similar step has run. Methods train and
  /// generate differently, but diagnosing and scoring take the same time for all methods.
  [[nodiscard]] std::optional<double> of(const Step& step) const {
    const bool is_of_method = step.stage == "train" || step.stage == "generate";
    const auto keys = keys_of(step);
    for (std::size_t i = 0; i < (is_of_method ? 2 : keys.size()); ++i) {
      const auto found = taken_.find(keys[i]);
      if (found == taken_.end() || found->second.count == 0) continue;
      return found->second.seconds / static_cast<double>(found->second.count);
    }
    return std::nullopt;
  }

 private:
  struct Sum {
    double seconds = 0;
    std::size_t count = 0;
  };

  static std::array<std::string, 5> keys_of(const Step& step) {
    const Place& place = step.place;
    const std::string by = step.log + '|' + place.ratio + '|' + place.classifier;
    return {by + '|' + place.dataset + '|' + unit_of(step), by + "||" + unit_of(step),
            by + '|' + place.dataset + '|', by + "||", step.log};
  }

 public:
  /// Returns the line of a step. All points of a sweep share a line, and so do all interpretations.
  static std::string unit_of(const Step& step) {
    const std::string& unit = step.place.unit;
    return unit.empty() ? shared : unit.substr(0, unit.find('/'));
  }

 private:
  std::map<std::string, Sum> taken_;
};

/// Names the data set in a line: a contrast has two runs.
std::string dataset_of(const Plan& plan, const Step& step) {
  const std::string blocked = plan.choice().folder_of(signal::Protocol::blocked) + '/';
  const bool is_other =
      plan.choice().protocol == signal::Protocol::random && step.folder.starts_with(blocked);
  return step.place.dataset + (is_other ? ", blocked" : "");
}

/// Finds the worst progress of a step and of all steps that it needs.
class Worst {
 public:
  Worst(const Graph& graph, const std::map<StepId, StepState>& states)
      : graph_(graph), states_(states) {}

  Progress of(StepId id) {
    if (const auto known = known_.find(id); known != known_.end()) return known->second;
    const auto own = states_.find(id);
    Progress worst = own == states_.end() ? Progress::done : own->second.progress;
    for (const StepId needed : graph_.needs(id)) worst = std::max(worst, of(needed));
    return known_[id] = worst;
  }

 private:
  const Graph& graph_;
  const std::map<StepId, StepState>& states_;
  std::map<StepId, Progress> known_;
};

class Rows {
 public:
  Row& of(const std::string& dataset, const std::string& unit) {
    const auto [found, is_new] = index_.emplace(dataset + '\t' + unit, rows_.size());
    if (is_new) rows_.push_back({.dataset = dataset, .unit = unit});
    return rows_[found->second];
  }
  [[nodiscard]] const std::vector<Row>& all() const { return rows_; }

 private:
  std::vector<Row> rows_;
  std::map<std::string, std::size_t> index_;
};

std::string time_left(const Row& row) {
  if (!row.any_unknown) return duration(row.seconds_left);
  return row.seconds_left > 0 ? duration(row.seconds_left) + " or more" : "not known yet";
}

std::string line_of(const Row& row, std::size_t dataset_width, std::size_t unit_width) {
  const auto count = [&](Progress progress) {
    return row.cells[static_cast<std::size_t>(progress)];
  };
  return fmt::format("{:<{}}  {:<{}}  {:>6}  {:>6}  {:>7}  {:>6}  {:>7}  {}\n", row.dataset,
                     dataset_width, row.unit, unit_width, row.all(), count(Progress::done),
                     count(Progress::running), count(Progress::failed), count(Progress::missing),
                     time_left(row));
}

Row sum_of(const std::vector<Row>& rows) {
  Row sum{.dataset = "all", .unit = ""};
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.cells.size(); ++i) sum.cells[i] += row.cells[i];
    sum.seconds_left += row.seconds_left;
    sum.any_unknown = sum.any_unknown || row.any_unknown;
  }
  return sum;
}

/// Formats the lines as a table. `counted` names the unit, such as "cells"; `running` is the number
/// of running steps.
std::string status_lines(const std::vector<Row>& rows, const char* counted, std::size_t running) {
  std::size_t dataset_width = std::string("data set").size();
  std::size_t unit_width = std::string("method").size();
  for (const Row& row : rows) {
    dataset_width = std::max(dataset_width, row.dataset.size());
    unit_width = std::max(unit_width, row.unit.size());
  }
  std::string text = fmt::format("{:<{}}  {:<{}}  {:>6}  {:>6}  {:>7}  {:>6}  {:>7}  time left\n",
                                 "data set", dataset_width, "method", unit_width, counted, "done",
                                 "running", "failed", "missing");
  for (const Row& row : rows) text += line_of(row, dataset_width, unit_width);
  const Row sum = sum_of(rows);
  text += line_of(sum, dataset_width, unit_width);
  if (running > 1) {
    text += fmt::format("\n{} steps run at a time: {}{} left at this rate\n", running,
                        duration(sum.seconds_left / static_cast<double>(running)),
                        sum.any_unknown ? " or more" : "");
  }
  return text;
}

}  // namespace

std::string status_table(Plan& plan, const std::map<StepId, StepState>& states, Logs& logs) {
  const Words& counts = goal_named(plan.choice().goals.front()).counts;
  const Durations durations(plan, logs);
  Worst worst(plan.graph(), states);
  Rows rows;
  std::size_t running = 0;
  for (const StepId id : plan.requested()) {
    const Step& step = plan.graph().at(id);
    const auto state = states.find(id);
    const bool is_of_cells = step.is_artefact && step.log != "features";
    if (!is_of_cells) continue;
    if (state != states.end()) {
      Row& row = rows.of(dataset_of(plan, step), Durations::unit_of(step));
      const auto seconds = durations.of(step);
      if (seconds) row.seconds_left += *seconds;
      row.any_unknown = row.any_unknown || !seconds;
      if (state->second.progress == Progress::running) ++running;
    }
    if (has(counts, step.log)) {
      Row& row = rows.of(dataset_of(plan, step), Durations::unit_of(step));
      ++row.cells[static_cast<std::size_t>(worst.of(id))];
    }
  }
  return status_lines(rows.all(), has(counts, "train") ? "models" : "cells", running);
}

std::string listed_steps(const Plan& plan, const std::map<StepId, StepState>& states) {
  std::string text;
  const auto list = [&](Progress progress, const std::string& heading) {
    bool is_first = true;
    for (const auto& [id, state] : states) {
      if (state.progress != progress) continue;
      const Step& step = plan.graph().at(id);
      if (is_first) text += fmt::format("\n{}\n", heading);
      is_first = false;
      std::string reason = state.reason.empty() ? step.stage : state.reason;
      if (progress == Progress::failed) reason = fmt::format("{}: {}", step.stage, reason);
      text += fmt::format("  {}: {} (log: {})\n", below_run(step.folder), reason, log_of(step));
    }
  };
  list(Progress::running, "running");
  list(Progress::failed, "failed");
  return text;
}

}  // namespace piae::plan
