#include "run/tested_windows.hpp"

#include "run/cell.hpp"
#include "signal/ranges.hpp"
#include "signal/roles.hpp"

namespace piae::run {

TestedWindows read_tested_windows(const artefact::Reader& reader, const std::string& dataset,
                                  std::int64_t seed) {
  signal::require_role(reader, signal::Role::test);
  require_same(reader, "the data set", reader.text("/", "dataset"), dataset);
  require_same(reader, "the seed",
               std::to_string(reader.integer("/", "seed", signal::ranges::seed)),
               std::to_string(seed));
  TestedWindows windows;
  windows.labels = reader.numbers<Label>("/labels", {0}).values;
  const std::size_t count = windows.labels.size();
  windows.places.record = reader.numbers<std::int32_t>("/record/index", {count}).values;
  windows.places.first_sample = reader.numbers<std::int64_t>("/first_sample", {count}).values;
  return windows;
}

}  // namespace piae::run
