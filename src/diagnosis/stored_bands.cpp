#include "diagnosis/stored_bands.hpp"

#include <span>

namespace piae::diagnosis {

namespace {

constexpr auto stored_columns = static_cast<std::size_t>(number_of_bands);

}  // namespace

void write_bands(artefact::Writer& writer, const std::string& group, const BandPowers& bands,
                 const std::vector<Label>& labels) {
  const std::span<const double> values(bands.data(), static_cast<std::size_t>(bands.size()));
  writer.numbers(group + "/bands", values, {labels.size(), stored_columns});
  writer.numbers(group + "/labels", labels);
}

std::vector<Label> read_labels(const artefact::Reader& reader, const std::string& group,
                               const signal::DatasetInfo& info) {
  const std::string path = group + "/labels";
  std::vector<Label> labels = reader.numbers<Label>(path, {0}).values;
  if (labels.empty()) reader.refuse(path, "is empty");
  for (const Label label : labels) {
    if (label < 0 || index_of(label) >= info.classes.size()) {
      reader.refuse(path, "has a label that no class has");
    }
  }
  return labels;
}

BandPowers read_bands(const artefact::Reader& reader, const std::string& group, std::size_t n) {
  const auto bands = reader.numbers<double>(group + "/bands", {n, stored_columns});
  return Eigen::Map<const BandPowers>(bands.values.data(), static_cast<Eigen::Index>(n),
                                      number_of_bands);
}

}  // namespace piae::diagnosis
