#include "report/verdict.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <ranges>

#include "augment/catalogue.hpp"
#include "diagnosis/catalogue.hpp"
#include "report/accuracies.hpp"
#include "report/labels.hpp"

namespace piae::report {

namespace {

std::string type_label(const std::string& name, const AccuracyRow& row) {
  return fmt::format("{} {:.1f} ({})", name, row.type_accuracy->mean, short_ratio_label(row.ratio));
}

bool is_rule(const AccuracyRow& row) { return row.method == augment::no_method; }
bool is_of_ceiling(const AccuracyRow& row) { return augment::is_ceiling(row.method); }
bool is_of_method(const AccuracyRow& row) { return !is_rule(row) && !is_of_ceiling(row); }

std::string named(const AccuracyRow& row) {
  if (is_rule(row))
    return fmt::format("{} ({:.1f} %)", diagnosis::marked_name(row.classifier), row.summary.mean);
  return fmt::format("{} by {} ({:.1f} %, {})", row.method, diagnosis::marked_name(row.classifier),
                     row.summary.mean, short_ratio_label(row.ratio));
}

/// Returns "shift (+35.2)", or "shift (+35.2, 1 seed)" if others have more seeds.
std::string with_points(const std::vector<AccuracyRow>& gains, std::size_t most_seeds) {
  std::vector<std::string> words;
  words.reserve(gains.size());
  for (const AccuracyRow& gain : gains) {
    const std::size_t seeds = gain.seeds.size();
    const std::string fewer = seeds < most_seeds ? ", " + counted(seeds, "seed") : "";
    words.push_back(fmt::format("{} ({:+.1f}{})", gain.method, gain.summary.mean, fewer));
  }
  return listed(words);
}

/// Returns the gains of all methods and ceilings at the ratio with the most generated windows. At
/// least half of the methods must have that ratio; otherwise it shows little.
std::vector<AccuracyRow> largest_gains(const std::vector<AccuracyRow>& rows) {
  std::vector<AccuracyRow> gains = gain_rows(rows);
  const std::size_t methods = methods_of(gains).size();
  std::int64_t most = 0;
  for (const AccuracyRow& gain : gains) {
    const std::int64_t generated = gain.generated_per_class;
    const auto having = std::ranges::count(gains, generated, &AccuracyRow::generated_per_class);
    const bool half = 2 * static_cast<std::size_t>(having) >= methods;
    if (half || most == 0) most = std::max(most, generated);
  }
  std::erase_if(gains, [&](const AccuracyRow& gain) { return gain.generated_per_class != most; });
  return gains;
}

/// Reports only numbers, because one or two seeds cannot distinguish an effect from chance. `gains`
/// are sorted.
std::string of_few_seeds(std::vector<AccuracyRow> gains, const AccuracyRow& baseline,
                         const std::string& ceiling) {
  const std::int64_t generated = gains.front().generated_per_class;
  const std::size_t seeds = baseline.values.size();
  std::erase_if(gains, [](const AccuracyRow& gain) { return augment::is_ceiling(gain.method); });
  return fmt::format(
      "With {} generated windows of each fault, in points against the {:.1f} % without any: {}{}. "
      "{}, too few to distinguish an effect from chance.",
      generated, baseline.summary.mean, with_points(gains, seeds), ceiling,
      seeds == 1 ? "This is one seed" : "These are two seeds");
}

std::string effects_of_methods(std::vector<AccuracyRow> gains, const AccuracyRow& baseline) {
  std::array<std::vector<AccuracyRow>, 3> by_effect;
  std::string ceiling;
  std::ranges::stable_sort(gains, std::ranges::greater(),
                           [](const AccuracyRow& gain) { return gain.summary.mean; });
  for (const AccuracyRow& gain : gains) {
    if (augment::is_ceiling(gain.method)) {
      ceiling = fmt::format("; real windows instead ({}) would give {:+.1f}", gain.method,
                            gain.summary.mean);
    } else {
      by_effect[static_cast<std::size_t>(effect_of(gain))].push_back(gain);
    }
  }
  const std::size_t seeds = baseline.values.size();
  if (seeds < 3) return of_few_seeds(gains, baseline, ceiling);
  constexpr std::array effects{"help", "make no clear difference", "harm"};
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < effects.size(); ++i) {
    if (by_effect[i].empty()) continue;
    const bool one = by_effect[i].size() == 1;
    const std::string verb = i == 1 && one ? "makes no clear difference"
                                           : std::string(effects[i]) + (one && i != 1 ? "s" : "");
    parts.push_back(with_points(by_effect[i], seeds) + ' ' + verb);
  }
  return fmt::format(
      "With {} generated windows of each fault, in points against the {:.1f} % without any ({} "
      "seeds), {}{}.",
      gains.front().generated_per_class, baseline.summary.mean, seeds, listed(parts), ceiling);
}

/// Returns the mean of a metric over classes and seeds; nothing if the method has no score.
std::optional<double> mean_of(const run::Results& results, const std::string& method,
                              double scoring::ClassQuality::*metric) {
  double sum = 0;
  std::size_t count = 0;
  for (const scoring::QualityRecord& record : results.qualities) {
    if (record.method != method) continue;
    for (const scoring::ClassQuality& quality : record.classes) sum += quality.*metric;
    count += record.classes.size();
  }
  return count == 0 ? std::nullopt : std::optional(sum / static_cast<double>(count));
}

std::string against_real(const run::Results& results, const std::string& method) {
  const auto amplitude = mean_of(results, method, &scoring::ClassQuality::amplitude_ratio);
  const auto line = mean_of(results, method, &scoring::ClassQuality::fault_line_difference_db);
  if (!amplitude || !line) return "";
  return fmt::format(
      "{:.0f} % as strong as real ones and show the lines of their fault {:.1f} dB {}",
      100 * *amplitude, std::abs(*line), *line < 0 ? "weaker" : "stronger");
}

/// Returns the start of the sentence on the paper's method if it gains nothing, or less than half
/// of what real windows gain; "" otherwise.
std::string falls_short(const std::vector<AccuracyRow>& gains, const AccuracyRow& gain) {
  const bool is_told = gain.summary.interval.has_value();
  if (is_told && effect_of(gain) != Effect::helps) return "As published, " + gain.method;
  const auto ceiling = std::ranges::find_if(
      gains, [](const AccuracyRow& each) { return augment::is_ceiling(each.method); });
  if (ceiling == gains.end() || gain.summary.mean >= ceiling->summary.mean / 2) return "";
  return fmt::format("{} gains {:.1f} of these {:.1f} points: as published, it", gain.method,
                     gain.summary.mean, ceiling->summary.mean);
}

std::string why_it_falls_short(const run::Results& results, const std::vector<AccuracyRow>& gains) {
  const std::string& method = augment::paper_method();
  const auto gain = std::ranges::find(gains, method, &AccuracyRow::method);
  if (gain == gains.end()) return "";
  const std::string beginning = falls_short(gains, *gain);
  const std::string measured = against_real(results, method);
  if (beginning.empty() || measured.empty()) return "";
  return fmt::format(
      "{} describes a window by stiffness and damping, which do not fix the shaft angle at which "
      "it starts, so it learns little more than the mean of a class: its windows are {}.",
      beginning, measured);
}

std::string without_any_of_this(const AccuracyRow& reference_row) {
  return fmt::format(
      "The classifier {}, {}, is correct in {:.1f} % of the test windows with the known windows "
      "only.",
      reference_row.classifier, diagnosis::the_classifier(reference_row.classifier).what,
      reference_row.summary.mean);
}

}  // namespace

std::string conditions_note(const run::Results& results) {
  if (results.diagnoses.empty()) return "";
  const run::Diagnosis& any = results.diagnoses.front();
  if (!any.any_known) return "No fault window was known.";
  if (any.known_at.empty()) return "";
  return fmt::format("Faults are known at {}, and tested at {}.", listed(any.known_at),
                     listed(any.tested_at));
}

std::string types_sentence(const ClassifierRows& block) {
  if (!have_fault_types(block.rows)) return "";
  std::string text;
  const auto add = [&](const std::string& label) { text += (text.empty() ? "" : ", ") + label; };
  for (const std::string& method : methods_of(block.rows)) {
    const std::vector<AccuracyRow> own = rows_of(block.rows, method);
    add(type_label(method_label(method),
                   *std::ranges::max_element(own, {}, &AccuracyRow::generated_per_class)));
  }
  if (block.reference_row)
    add(type_label(reference_label(*block.reference_row), *block.reference_row));
  return "By fault type: " + text + ".";
}

std::string most_accurate_without_known(const std::vector<AccuracyRow>& rows) {
  std::vector<std::string> parts;
  const auto add_best = [&](const std::string& with, bool (*of_group)(const AccuracyRow&)) {
    const AccuracyRow* best = nullptr;
    for (const AccuracyRow& row : rows) {
      if (!of_group(row)) continue;
      if (best == nullptr || row.summary.mean > best->summary.mean) best = &row;
    }
    if (best != nullptr) parts.push_back(with + " " + named(*best));
  };
  add_best("with generated windows", is_of_method);
  add_best("by a rule", is_rule);
  add_best("with real windows instead", is_of_ceiling);
  return parts.empty() ? "" : "Most accurate: " + listed(parts) + ".";
}

Effect effect_of(const AccuracyRow& gain) {
  const auto& interval = gain.summary.interval;
  if (interval && interval->low > 0) return Effect::helps;
  return interval && interval->high < 0 ? Effect::harms : Effect::no_clear_difference;
}

std::vector<std::string> verdict(const run::Results& results,
                                 const std::vector<AccuracyRow>& rows) {
  const std::vector<ClassifierRows> blocks = by_classifier(rows);
  if (blocks.empty()) return {};
  const ClassifierRows& shown = blocks.front();
  const std::vector<AccuracyRow> gains = largest_gains(shown.rows);
  const bool any_known = results.diagnoses.empty() || results.diagnoses.front().any_known;
  if (!any_known) return {most_accurate_without_known(rows)};
  if (gains.empty()) return {};
  std::vector<std::string> sentences{
      effects_of_methods(gains, *find_row(shown.rows, augment::no_method, ""))};
  std::string reason = why_it_falls_short(results, gains);
  if (!reason.empty()) sentences.push_back(std::move(reason));
  if (shown.reference_row) sentences.push_back(without_any_of_this(*shown.reference_row));
  return sentences;
}

}  // namespace piae::report
