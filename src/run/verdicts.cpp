#include "run/verdicts.hpp"

#include <algorithm>

namespace piae::run {

bool Verdicts::is_faulty(const classification::Named& record) const {
  return record.true_class != info.class_of(info.healthy_label()).name;
}

std::size_t Verdicts::count_right_faults() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(records, [&](const classification::Named& record) {
        return is_faulty(record) && record.fault == record.true_class;
      }));
}

Verdicts read_verdicts(const Layout& layout, const Combination& cell, std::int64_t seed) {
  const artefact::Reader reader(
      layout.classification(cell.method, cell.ratio, seed, cell.classifier), "classification");
  const artefact::Reader kept(
      layout.kept_classifier(cell.method, cell.ratio, seed, cell.classifier), "classifier");
  if (reader.text("/", "classifier_digest") != kept.digest()) {
    reader.refuse("/", "was not made by " + kept.path().string());
  }
  return {.info = signal::read_dataset_info(reader),
          .protocol = signal::read_protocol(kept),
          .records = classification::read_named(reader)};
}

}  // namespace piae::run
