#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "artefact/writer.hpp"
#include "base/label.hpp"
#include "run/layout.hpp"
#include "scoring/decisions.hpp"

namespace piae {

/// Stores the parts of a seed's test windows that decisions need, without samples.
inline artefact::Written save_tested_windows(const run::Layout& layout, const std::string& dataset,
                                             std::int64_t seed, const std::vector<Label>& labels,
                                             const scoring::Places& places,
                                             const artefact::Provenance& provenance = {
                                                 "test", "", {}}) {
  artefact::Writer writer("windows");
  writer.attribute("/", "role", std::string("A"));
  writer.attribute("/", "dataset", dataset);
  writer.attribute("/", "seed", seed);
  writer.numbers("/labels", labels);
  writer.numbers("/record/index", places.record);
  writer.numbers("/first_sample", places.first_sample);
  return writer.save(layout.windows("A", seed), provenance);
}

/// Returns the places of consecutive windows in one record.
inline scoring::Places one_record(std::size_t windows) {
  scoring::Places places{.record = std::vector<std::int32_t>(windows), .first_sample = {}};
  for (std::size_t i = 0; i < windows; ++i) {
    places.first_sample.push_back(static_cast<std::int64_t>(1024 * i));
  }
  return places;
}

}  // namespace piae
