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

#include "page/links.hpp"
#include "page/table.hpp"
#include "report/columns.hpp"
#include "report/gaps.hpp"
#include "report/labels.hpp"

namespace piae::page {

namespace {

/// So many reasons and logs of a group are shown; the others are counted.
constexpr std::size_t most_shown = 3;

/// Values of which each is kept once, in the order in which they come. There may be as many as
/// there are cells.
template <class T>
class EachOnce {
 public:
  void add(const T& value) {
    if (known_.insert(value).second) values_.push_back(value);
  }
  [[nodiscard]] std::vector<T> take() { return std::move(values_); }

 private:
  std::vector<T> values_;
  std::set<T> known_;
};

/// A group to which holes are still added.
struct GrowingGroup {
  HoleGroup group;
  EachOnce<std::string> methods = {};
  EachOnce<std::string> ratios = {};
  EachOnce<std::int64_t> seeds = {};
  EachOnce<std::string> reasons = {};
  EachOnce<std::filesystem::path> logs = {};
};

std::string method_of(const Hole& hole) {
  return run::name_by(hole.name.method, hole.name.classifier);
}

/// What the holes of a group have in common. What is not begun has no method in common.
using CommonOfHoles = std::tuple<HoleState, std::string, std::string>;
CommonOfHoles common_of(const Hole& hole) {
  return {hole.state, hole.stage, hole.state == HoleState::not_begun ? "" : method_of(hole)};
}

void add(GrowingGroup& growing, const Hole& hole) {
  growing.methods.add(method_of(hole));
  growing.seeds.add(hole.name.seed);
  if (hole.name.ratio.empty()) {
    ++growing.group.scores;
  } else {
    ++growing.group.diagnoses;
    growing.ratios.add(hole.name.ratio);
  }
  if (!hole.why.empty()) growing.reasons.add(hole.why);
  if (!hole.log.empty()) growing.logs.add(hole.log);
}

HoleGroup grown(GrowingGroup growing) {
  HoleGroup group = std::move(growing.group);
  group.methods = growing.methods.take();
  group.ratios = growing.ratios.take();
  group.seeds = growing.seeds.take();
  group.reasons = growing.reasons.take();
  group.logs = growing.logs.take();
  std::ranges::sort(group.seeds);
  return group;
}

std::vector<HoleGroup> groups_of_dataset(const DatasetContents& dataset) {
  std::vector<GrowingGroup> groups;
  std::map<CommonOfHoles, std::size_t> places;
  for (const Hole& hole : dataset.holes) {
    const auto [place, is_new] = places.try_emplace(common_of(hole), groups.size());
    if (is_new) {
      groups.push_back(
          {.group = {.dataset = dataset.name, .state = hole.state, .stage = hole.stage}});
    }
    add(groups[place->second], hole);
  }
  std::vector<HoleGroup> all;
  all.reserve(groups.size());
  for (GrowingGroup& growing : groups) all.push_back(grown(std::move(growing)));
  return all;
}

std::size_t count_of(const std::vector<DatasetContents>& datasets, HoleState state) {
  std::size_t count = 0;
  for (const DatasetContents& dataset : datasets) {
    count += static_cast<std::size_t>(std::ranges::count(dataset.holes, state, &Hole::state));
  }
  return count;
}

constexpr std::array all_states{HoleState::failed, HoleState::refused, HoleState::interrupted,
                                HoleState::open, HoleState::not_begun};

/// A sign beside the word, so that neither colour nor reading is needed to find what is wrong.
std::string sign_of(HoleState state) {
  switch (state) {
    case HoleState::failed:
    case HoleState::refused:
      return "✖ ";
    case HoleState::interrupted:
    case HoleState::open:
      return "‖ ";
    case HoleState::not_begun:
      break;
  }
  return "○ ";
}

std::string and_others(std::size_t count) {
  return count > most_shown ? fmt::format(" and {} more", count - most_shown) : "";
}

std::string reasons_of(const HoleGroup& group) {
  const std::span shown(group.reasons.data(), std::min(most_shown, group.reasons.size()));
  std::string text = fmt::format("{}", fmt::join(shown, "; "));
  if (text.empty() && !group.stage.empty()) text = group.stage + " is not done";
  return text + and_others(group.reasons.size());
}

text::Cell logs_of(const HoleGroup& group) {
  text::Cell cell = and_others(group.logs.size());
  for (const auto& log : std::span(group.logs).first(std::min(most_shown, group.logs.size()))) {
    cell.files.push_back(log);
  }
  return cell;
}

Html table_of_hole_groups(const std::vector<HoleGroup>& groups) {
  text::Table table({"state", "data set", "which", "cells", "reason", "log"}, 6);
  for (const HoleGroup& group : groups) {
    text::Cell reasons = reasons_of(group);
    reasons.looks = "reason";
    table.row({sign_of(group.state) + word_of(group.state), group.dataset, cells_label(group),
               report::labelled_cell(static_cast<double>(group.diagnoses + group.scores),
                                     counted_cells(group.diagnoses, group.scores)),
               reasons, logs_of(group)},
              group.state == HoleState::not_begun ? "" : "bad");
  }
  return html(report::Section{"missing", "What is missing, and why", "", table});
}

}  // namespace

std::string word_of(HoleState state) {
  switch (state) {
    case HoleState::failed:
      return "failed";
    case HoleState::refused:
      return "refused";
    case HoleState::interrupted:
      return "interrupted";
    case HoleState::open:
      return "running or killed";
    case HoleState::not_begun:
      break;
  }
  return "not begun";
}

std::vector<HoleGroup> groups_of(const std::vector<DatasetContents>& datasets) {
  std::vector<HoleGroup> groups;
  for (const DatasetContents& dataset : datasets) {
    std::ranges::move(groups_of_dataset(dataset), std::back_inserter(groups));
  }
  std::ranges::stable_sort(groups, {}, &HoleGroup::state);
  return groups;
}

std::string cells_label(const HoleGroup& group) {
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
    missing += dataset.holes.size();
  }
  if (missing == 0) return "All " + counted_cells(diagnoses, scores) + " are there.";
  std::vector<std::string> states;
  for (const HoleState state : all_states) {
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
  const std::vector<HoleGroup> groups = groups_of(datasets);
  if (groups.empty() && damaged.empty()) {
    return element("p", {{"class", "complete"}}, "✔ " + completeness(datasets));
  }
  Html content = element("p", "⚠ " + completeness(datasets)) + damaged;
  if (!groups.empty()) {
    content +=
        table_of_hole_groups(groups) +
        element("p", "No mean below includes them. The same make command goes on from here.");
  }
  return element("section", {{"class", "problems"}, {"aria-label", "What is missing"}}, content);
}

}  // namespace piae::page
