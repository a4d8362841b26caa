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

std::vector<std::string> Source::inferring_methods() const {
  std::vector<std::string> methods;
  for (const std::string& method : grid_.scored) {
    const augment::CatalogueEntry* entry = augment::find_entry(method);
    if (entry != nullptr && entry->infers) methods.push_back(method);
  }
  if (methods.empty()) {
    throw LeftOut("no method here infers (k, c)");
  }
  return methods;
}

const std::vector<report::AccuracyRow>& Source::accuracy_rows() {
  if (!rows_) {
    run::Grid diagnosed = grid_;
    diagnosed.scored.clear();
    const run::Results results = run::collect(layout_, diagnosed);
    require_whole(results);
    rows_ = report::accuracy_rows(diagnosed, results, published_);
  }
  return *rows_;
}

const std::vector<scoring::QualityRecord>& Source::qualities() {
  if (!qualities_) {
    run::Grid scored = grid_;
    scored.combinations.clear();
    run::Results results = run::collect(layout_, scored);
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

scoring::DiagnosisRecord Source::diagnosis(const run::Combination& cell, std::int64_t seed) const {
  return read({layout_.diagnosis(cell.method, cell.ratio, seed), "diagnosis"}, cell, seed);
}

scoring::DiagnosisRecord Source::features(const run::Combination& cell, std::int64_t seed) const {
  const artefact::Reader reader(layout_.features(cell.method, cell.ratio, seed), "diagnosis");
  scoring::DiagnosisRecord record = read(reader, cell, seed);
  if (!record.features) {
    reader.refuse("/features", "is missing; diagnose --keep-features stores it");
  }
  return record;
}

artefact::Reader Source::model(const std::string& method, std::int64_t seed) const {
  const auto of_method = [&](const run::Combination& cell) { return cell.method == method; };
  if (std::ranges::none_of(grid_.combinations, of_method)) {
    throw LeftOut("the method " + method + " is not among those asked for");
  }
  return {layout_.model(method, seed), "model"};
}

}  // namespace piae::figures
