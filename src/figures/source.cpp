#include "figures/source.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "augment/catalogue.hpp"

namespace piae::figures {

void require_whole(const run::Results& results) {
  if (results.problems.empty()) return;
  const std::size_t others = results.problems.size() - 1;
  const std::string& first = results.problems.front();
  if (others == 0) throw Error(results.exit, first);
  throw Error(results.exit, fmt::format("{} (and {} more)", first, others));
}

Source::Source(run::Layout layout, run::Grid requested, report::Published published,
               const std::vector<std::string>& leave_out, std::vector<run::StepCost> costs)
    : layout_(std::move(layout)),
      requested_(std::move(requested)),
      held_(layout_, leave_out),
      grid_(held_grid(layout_, requested_, held_)),
      published_(std::move(published)),
      costs_(std::move(costs)) {
  if (grid_.combinations.empty()) {
    throw Error(Exit::input_missing,
                layout_.folder().string() +
                    (leave_out.empty() ? ": holds no cell; run `make cells`"
                                       : ": holds only stale cells; `make why` gives the reasons"));
  }
  grid_ = run::of_classifier(std::move(grid_), scoring::paper_classifier);
}

bool Source::has(const std::string& method, std::int64_t seed,
                 const std::filesystem::path& file) const {
  const bool is_requested =
      std::ranges::count(requested_.seeds, seed) > 0 &&
      std::ranges::count(requested_.combinations, method, &run::Combination::method);
  return is_requested || held_.has(file);
}

std::vector<std::int64_t> Source::seeds_of(const run::Combination& cell) const {
  const bool is_requested = std::ranges::count(requested_.combinations, cell) > 0;
  return held_.seeds_with(
      is_requested ? requested_.seeds : std::vector<std::int64_t>{}, [&](std::int64_t seed) {
        return layout_.diagnosis(cell.method, cell.ratio, seed, cell.classifier);
      });
}

std::vector<std::string> Source::inferring_methods() const {
  std::vector<std::string> methods;
  for (const std::string& method : grid_.scored) {
    const augment::CatalogueEntry* entry = augment::find_entry(method);
    const bool infers = entry != nullptr && entry->infers;
    if (infers && has(method, shown_seed(), layout_.model(method, shown_seed()))) {
      methods.push_back(method);
    }
  }
  if (methods.empty()) {
    throw LeftOut("no method here infers (k, c)");
  }
  return methods;
}

const run::Results& Source::results() {
  if (!diagnoses_) diagnoses_ = run::collect_held_diagnoses(layout_, requested_, held_);
  return diagnoses_->results;
}

const std::vector<report::ClassifierRows>& Source::accuracies() {
  if (!accuracies_) {
    require_whole(results());
    accuracies_ = report::by_classifier(
        report::accuracy_rows(diagnoses_->grid, diagnoses_->results, published_));
  }
  return *accuracies_;
}

const std::vector<scoring::QualityRecord>& Source::qualities() {
  if (!qualities_) {
    run::Results results = run::collect_held_scores(layout_, requested_, held_);
    require_whole(results);
    qualities_ = std::move(results.qualities);
  }
  return *qualities_;
}

scoring::DiagnosisRecord Source::read(const artefact::Reader& reader, const run::Combination& cell,
                                      std::int64_t seed) const {
  run::read_diagnosis_cell(reader, grid_.dataset, cell, seed);
  return scoring::read_diagnosis(reader);
}

std::vector<scoring::DiagnosisRecord> Source::diagnoses(
    const run::Combination& cell, const std::vector<std::int64_t>& seeds) const {
  std::vector<std::filesystem::path> paths;
  paths.reserve(seeds.size());
  for (const std::int64_t seed : seeds) {
    paths.push_back(layout_.diagnosis(cell.method, cell.ratio, seed, cell.classifier));
  }
  artefact::Readers readers(std::move(paths), "diagnosis");
  std::vector<scoring::DiagnosisRecord> records;
  records.reserve(seeds.size());
  for (const std::int64_t seed : seeds) records.push_back(read(readers.next(), cell, seed));
  return records;
}

scoring::DiagnosisRecord Source::features(const run::Combination& cell, std::int64_t seed) const {
  const artefact::Reader reader(layout_.features(cell.method, cell.ratio, seed), "diagnosis");
  scoring::DiagnosisRecord record = read(reader, cell, seed);
  if (!record.features) {
    reader.refuse("/features", "is missing; run diagnose with --keep-features");
  }
  return record;
}

artefact::Reader Source::model(const std::string& method, std::int64_t seed) const {
  const auto of_method = [&](const run::Combination& cell) { return cell.method == method; };
  if (std::ranges::none_of(grid_.combinations, of_method)) {
    throw LeftOut("the run has no cell of the method " + method);
  }
  return {layout_.model(method, seed), "model"};
}

}  // namespace piae::figures
