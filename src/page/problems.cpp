#include "page/problems.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "page/html.hpp"
#include "page/table.hpp"
#include "report/columns.hpp"
#include "report/gaps.hpp"
#include "report/labels.hpp"

namespace piae::page {

namespace {

/// Number of reasons and logs that a group shows; the others are counted.
constexpr std::size_t most_shown = 3;

/// Keeps each value once, in order of arrival. There may be as many values as cells.
template <class T>
class EachOnce {
 public:
  void add(const T& value, std::vector<T>& to) {
    if (known_.insert(value).second) to.push_back(value);
  }

 private:
  std::set<T> known_;
};

std::string method_of(const MissingCell& missing_cell) {
  return run::name_by(missing_cell.name.method, missing_cell.name.classifier);
}

/// Key of a group of missing cells. Cells that were not started are grouped without their method.
using CommonOfMissing = std::tuple<MissingState, std::string, std::string>;
CommonOfMissing common_of(const MissingCell& missing_cell) {
  return {missing_cell.state, missing_cell.stage,
          missing_cell.state == MissingState::not_started ? "" : method_of(missing_cell)};
}

std::vector<MissingGroup> groups_of_dataset(const DatasetContents& dataset) {
  struct Seen {
    EachOnce<std::string> methods, ratios, reasons;
    EachOnce<std::int64_t> seeds;
    EachOnce<std::filesystem::path> logs;
  };
  std::vector<MissingGroup> groups;
  std::vector<Seen> seen;
  std::map<CommonOfMissing, std::size_t> places;
  for (const MissingCell& missing_cell : dataset.missing_cells) {
    const auto [place, is_new] = places.try_emplace(common_of(missing_cell), groups.size());
    if (is_new) {
      groups.push_back(
          {.dataset = dataset.name, .state = missing_cell.state, .stage = missing_cell.stage});
      seen.emplace_back();
    }
    MissingGroup& group = groups[place->second];
    Seen& known = seen[place->second];
    known.methods.add(method_of(missing_cell), group.methods);
    known.seeds.add(missing_cell.name.seed, group.seeds);
    ++(missing_cell.name.ratio.empty() ? group.scores : group.diagnoses);
    if (!missing_cell.name.ratio.empty()) known.ratios.add(missing_cell.name.ratio, group.ratios);
    if (!missing_cell.why.empty()) known.reasons.add(missing_cell.why, group.reasons);
    if (!missing_cell.log.empty()) known.logs.add(missing_cell.log, group.logs);
  }
  for (MissingGroup& group : groups) std::ranges::sort(group.seeds);
  return groups;
}

std::size_t count_of(const std::vector<DatasetContents>& datasets, MissingState state) {
  std::size_t count = 0;
  for (const DatasetContents& dataset : datasets) {
    count += static_cast<std::size_t>(
        std::ranges::count(dataset.missing_cells, state, &MissingCell::state));
  }
  return count;
}

struct StateWords {
  const char* sign;  ///< shows problems without colour or words
  const char* word;
};
/// Indexed by MissingState.
constexpr std::array<StateWords, 5> words_of_states{{{"✖", "failed"},
                                                     {"✖", "refused"},
                                                     {"‖", "interrupted"},
                                                     {"‖", "running or killed"},
                                                     {"○", "not started"}}};

const StateWords& words_of(MissingState state) {
  return words_of_states.at(static_cast<std::size_t>(state));
}

std::string and_others(std::size_t count) {
  return count > most_shown ? fmt::format(" and {} more", count - most_shown) : "";
}

std::string reasons_of(const MissingGroup& group) {
  const std::span shown(group.reasons.data(), std::min(most_shown, group.reasons.size()));
  std::string text = fmt::format("{}", fmt::join(shown, "; "));
  if (text.empty() && !group.stage.empty()) text = group.stage + " is not done";
  return text + and_others(group.reasons.size());
}

text::Cell logs_of(const MissingGroup& group) {
  text::Cell cell = and_others(group.logs.size());
  for (const auto& log : std::span(group.logs).first(std::min(most_shown, group.logs.size()))) {
    cell.files.push_back(log);
  }
  return cell;
}

Html table_of_missing(const std::vector<MissingGroup>& groups) {
  text::Table table({"state", "data set", "which", "cells", "reason", "log"}, 6);
  for (const MissingGroup& group : groups) {
    text::Cell reasons = reasons_of(group);
    reasons.looks = "reason";
    table.row({fmt::format("{} {}", words_of(group.state).sign, words_of(group.state).word),
               group.dataset, cells_label(group),
               report::labelled_cell(static_cast<double>(group.diagnoses + group.scores),
                                     counted_cells(group.diagnoses, group.scores)),
               reasons, logs_of(group)},
              group.state == MissingState::not_started ? "" : "bad");
  }
  return html(report::Section{"missing", "What is missing, and why", "", table});
}

}  // namespace

std::string word_of(MissingState state) { return words_of(state).word; }

std::vector<MissingGroup> groups_of(const std::vector<DatasetContents>& datasets) {
  std::vector<MissingGroup> groups;
  for (const DatasetContents& dataset : datasets) {
    std::ranges::move(groups_of_dataset(dataset), std::back_inserter(groups));
  }
  std::ranges::stable_sort(groups, {}, &MissingGroup::state);
  return groups;
}

std::string cells_label(const MissingGroup& group) {
  std::vector<std::string> ratios;
  for (const std::string& ratio : group.ratios) ratios.push_back(report::short_ratio_label(ratio));
  std::string text = report::listed(group.methods);
  if (!ratios.empty()) text += "; " + report::listed(ratios);
  return text + "; seed" + (group.seeds.size() == 1 ? " " : "s ") + report::seed_list(group.seeds);
}

std::string completeness(const std::vector<DatasetContents>& datasets) {
  std::size_t diagnoses = 0;
  std::size_t scores = 0;
  std::size_t missing = 0;
  for (const DatasetContents& dataset : datasets) {
    diagnoses += dataset.results.diagnoses.size();
    scores += dataset.results.qualities.size();
    missing += dataset.missing_cells.size();
  }
  if (missing == 0) return "All " + counted_cells(diagnoses, scores) + " are there.";
  std::vector<std::string> states;
  for (std::size_t i = 0; i < words_of_states.size(); ++i) {
    const auto state = static_cast<MissingState>(i);
    const std::size_t count = count_of(datasets, state);
    if (count > 0) states.push_back(fmt::format("{} {}", count, word_of(state)));
  }
  return fmt::format("{} of {} cells {} missing: {}.", missing, missing + diagnoses + scores,
                     missing == 1 ? "is" : "are", report::listed(states));
}

Html problems_html(const std::vector<DatasetContents>& datasets) {
  Html damaged;
  for (const DatasetContents& dataset : datasets) {
    if (!dataset.records_problem.empty()) damaged += element("p", "✖ " + dataset.records_problem);
  }
  for (const DatasetContents& dataset : datasets) {
    const std::string left_out = report::left_out_line(dataset.results);
    if (!left_out.empty()) damaged += element("p", "⚠ " + dataset.name + ": " + left_out);
  }
  const std::vector<MissingGroup> groups = groups_of(datasets);
  if (groups.empty() && damaged.empty()) {
    return element("p", {{"class", "complete"}}, "✔ " + completeness(datasets));
  }
  Html content = element("p", "⚠ " + completeness(datasets)) + damaged;
  if (!groups.empty()) {
    content +=
        table_of_missing(groups) +
        element("p", "The means below do not include them. The same make command continues.");
  }
  return element("section", {{"class", "problems"}, {"aria-label", "What is missing"}}, content);
}

}  // namespace piae::page
