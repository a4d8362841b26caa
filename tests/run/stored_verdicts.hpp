#pragma once

#include <string>
#include <vector>

#include "classification/judged.hpp"
#include "classification/record.hpp"
#include "run/layout.hpp"

namespace piae::run {

/// Stores a kept classifier of cell none/100to1/nearest, and its verdicts on four records: a
/// healthy one, two of class 1 and one of class 2. `predicted` is the class of each.
inline void store_verdicts(const Layout& layout, std::int64_t seed,
                           const std::vector<int>& predicted) {
  const std::vector<std::string> records{"healthy", "a-1", "a-2", "b-1"};
  const std::vector<Label> truth{0, 1, 1, 2};
  artefact::Writer kept("classifier");
  kept.attribute("/", "seed", seed);
  kept.attribute("/", "protocol", to_string(signal::Protocol::random));
  const std::filesystem::path file = layout.kept_classifier("none", "100to1", seed, "nearest");
  kept.save(file, {"test", "", {}});
  const auto toys = classification::classifier_of_toys();
  std::vector<classification::Verdict> verdicts;
  for (std::size_t i = 0; i < predicted.size(); ++i) {
    verdicts.push_back(classification::judged(records[i], std::vector<int>(3, predicted[i]),
                                              toys.info().class_of(truth[i]).name));
  }
  artefact::Writer writer("classification");
  classification::write(writer, verdicts, toys, artefact::Reader(file, "classifier").digest());
  writer.save(layout.classification("none", "100to1", seed, "nearest"), {"test", "", {}});
}

}  // namespace piae::run
