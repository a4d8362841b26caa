#include "report/recommendation.hpp"

#include <algorithm>
#include <iterator>

#include "augment/catalogue.hpp"
#include "diagnosis/catalogue.hpp"
#include "report/accuracies.hpp"
#include "report/labels.hpp"
#include "report/ratio_means.hpp"

namespace piae::report {

namespace {

bool is_without_windows(const AccuracyRow& row) { return row.method == augment::no_method; }

/// Returns all rows that can be recommended at a ratio.
std::vector<AccuracyRow> rows_at(const std::vector<AccuracyRow>& rows, const std::string& ratio) {
  std::vector<AccuracyRow> own;
  std::ranges::copy_if(rows, std::back_inserter(own), [&](const AccuracyRow& row) {
    return !augment::is_ceiling(row.method) && (row.ratio == ratio || is_without_windows(row));
  });
  return own;
}

AccuracyRow at_seeds(AccuracyRow row, const std::vector<std::int64_t>& seeds) {
  std::vector<double> values(seeds.size());
  std::ranges::transform(seeds, values.begin(), [&](std::int64_t seed) { return *row.at(seed); });
  row.seeds = seeds;
  row.values = std::move(values);
  row.summary = summarise_within(percents, row.values);
  return row;
}

/// Returns the rows of the largest block without missing cells, at its seeds. Adds the names of the
/// other rows to `left_out`.
std::vector<AccuracyRow> without_gaps(const std::vector<AccuracyRow>& rows,
                                      std::vector<std::string>& left_out) {
  const std::vector<std::int64_t> seeds = seeds_of_any(rows);
  const auto has = [&](std::size_t r, std::size_t s) { return rows[r].at(seeds[s]).has_value(); };
  const Block block = largest_block(columns_of_rows(rows.size(), seeds.size(), has), 1, 1);
  std::vector<std::int64_t> common;
  for (const std::size_t s : block.columns) common.push_back(seeds[s]);
  std::vector<AccuracyRow> kept;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (std::ranges::count(block.rows, r) > 0) {
      kept.push_back(at_seeds(rows[r], common));
    } else {
      left_out.push_back(run::name_by(rows[r].method, rows[r].classifier));
    }
  }
  return kept;
}

/// Returns the row with the highest mean for each effort that occurs; of equal rows the first.
std::vector<Candidate> most_accurate_by_effort(const std::vector<AccuracyRow>& rows) {
  std::vector<Candidate> best;
  for (const AccuracyRow& row : rows) {
    const Effort effort = effort_of(row.method, row.classifier);
    const auto same = std::ranges::find(best, effort, &Candidate::effort);
    if (same == best.end()) {
      best.push_back({row, effort});
    } else if (row.summary.mean > same->row.summary.mean) {
      same->row = row;
    }
  }
  std::ranges::sort(best, {}, &Candidate::effort);
  return best;
}

scoring::Confusion confusion_of(const AccuracyRow& row, const run::Results& results) {
  scoring::Confusion sum;
  for (const run::Diagnosis& cell :
       run::diagnoses_of(results, {row.method, row.ratio, row.classifier})) {
    if (row.at(cell.seed)) scoring::add(sum, cell.confusion);
  }
  return sum;
}

/// Tests everything that takes less than the best as one family, whatever the ratio.
void compare_with_best(Recommendation& into) {
  std::vector<PairedRow> rows;
  for (const Candidate& each : into.by_effort) {
    rows.push_back(*paired_row(each.row, into.most_accurate().row));
    rows.back().ratio = into.ratio;
  }
  std::vector<PairedRow> family(rows.begin(),
                                rows.begin() + static_cast<std::ptrdiff_t>(into.best));
  add_holm_p(family);
  std::ranges::copy(family, rows.begin());
  into.can_decide = std::ranges::all_of(
      family, [](const PairedRow& row) { return row.p_holm && row.p_can_be_small; });
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i != into.best) into.by_effort[i].behind = std::move(rows[i]);
  }
}

std::size_t least_that_is_as_good(const Recommendation& of) {
  std::size_t i = of.can_decide ? 0 : of.best;
  while (i < of.best && *of.by_effort[i].behind->p_holm <= significance_level) ++i;
  return i;
}

Recommendation recommendation_at(const RatioColumn& column, const std::vector<AccuracyRow>& rows,
                                 const run::Results& results) {
  Recommendation made{
      .dataset = rows.front().dataset, .ratio = column.ratio, .ratio_label = column.label};
  const std::vector<AccuracyRow> compared = without_gaps(rows, made.left_out);
  made.compared = compared.size();
  made.several_classifiers = std::ranges::any_of(
      rows, [&](const AccuracyRow& row) { return row.classifier != rows.front().classifier; });
  made.by_effort = most_accurate_by_effort(compared);
  const auto best = std::ranges::max_element(
      made.by_effort, {}, [](const Candidate& each) { return each.row.summary.mean; });
  made.best = static_cast<std::size_t>(best - made.by_effort.begin());
  compare_with_best(made);
  made.taken = least_that_is_as_good(made);
  for (Candidate& each : made.by_effort) each.confusion = confusion_of(each.row, results);
  if (!results.diagnoses.empty()) made.classes = results.diagnoses.front().classes;
  return made;
}

}  // namespace

Effort effort_of(const std::string& method, const std::string& classifier) {
  const augment::CatalogueEntry* const entry = augment::find_entry(method);
  const diagnosis::Classifier* const judge = diagnosis::find_classifier(classifier);
  const bool generates = method != augment::no_method;
  const bool trains_generator = generates && (entry == nullptr || entry->trains);
  const bool trains_classifier = judge == nullptr || judge->trains();
  if (trains_generator) {
    return trains_classifier ? Effort::generator_and_classifier : Effort::generator;
  }
  if (trains_classifier) return generates ? Effort::windows_and_classifier : Effort::classifier;
  return generates ? Effort::windows : Effort::nothing;
}

std::size_t Recommendation::seeds_to_decide() const {
  if (best == 0) return 0;
  std::size_t seeds = 1;
  while (scoring::smallest_p(seeds) * static_cast<double>(best) > significance_level) ++seeds;
  return seeds;
}

std::vector<Recommendation> recommendations(const std::vector<AccuracyRow>& rows,
                                            const run::Results& results) {
  std::vector<AccuracyRow> own = rows;
  std::erase_if(own, [](const AccuracyRow& row) { return augment::is_ceiling(row.method); });
  std::vector<RatioColumn> columns = compared_columns(own);
  if (columns.empty()) columns = ratio_columns(own);
  std::vector<Recommendation> all;
  all.reserve(columns.size());
  for (const RatioColumn& column : columns) {
    all.push_back(recommendation_at(column, rows_at(own, column.ratio), results));
  }
  return all;
}

const Recommendation* main_recommendation(const std::vector<Recommendation>& all) {
  if (all.empty()) return nullptr;
  const std::size_t most = std::ranges::max(all, {}, &Recommendation::compared).compared;
  const auto last = std::find_if(all.rbegin(), all.rend(), [&](const Recommendation& each) {
    return 2 * each.compared >= most;
  });
  return &*last;
}

}  // namespace piae::report
