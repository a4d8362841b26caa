#include "transfer/stored_edges.hpp"

#include "transfer/ranges.hpp"

namespace piae::transfer {

namespace {

struct Part {
  const char* path;
  double Edges::*value;
  Range range;
};

constexpr Part parts[] = {{"/edges/lag_s", &Edges::lag_s, ranges::lag_s},
                          {"/edges/exit", &Edges::exit, ranges::exit},
                          {"/edges/spread", &Edges::spread, ranges::spread}};

}  // namespace

void write(artefact::Writer& writer, const std::vector<Edges>& edges) {
  for (const Part& part : parts) {
    std::vector<double> values;
    values.reserve(edges.size());
    for (const Edges& one : edges) values.push_back(one.*part.value);
    writer.numbers(part.path, values);
  }
}

std::vector<Edges> read_edges(const artefact::Reader& reader, std::size_t windows) {
  std::vector<Edges> edges(windows);
  for (const Part& part : parts) {
    const std::vector<double> values = reader.numbers<double>(part.path, {windows}).values;
    reader.require_all(part.path, values, part.range);
    for (std::size_t i = 0; i < windows; ++i) edges[i].*part.value = values[i];
  }
  return edges;
}

}  // namespace piae::transfer
