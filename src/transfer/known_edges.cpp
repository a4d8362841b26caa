#include "transfer/known_edges.hpp"

#include <cmath>

#include "impacts/ranges.hpp"
#include "impacts/response.hpp"
#include "transfer/known_bearings.hpp"

namespace piae::transfer {

namespace {

constexpr double band_from = 0.02;
constexpr double band_to = 0.91;

SeenBearing seen(const signal::WindowSet& known, const KnownBearing& bearing) {
  return {
      .log_amplitude = impacts::log_amplitude(known, bearing.windows),
      .passage_s = passage_s(known, bearing.windows.front(), bearing.size_mm, bearing.speed_rpm)};
}

Band band_of(const signal::WindowSet& known) {
  const auto bins = static_cast<double>(known.length + known.length % 2);
  return {.bin_hz = known.info.sample_rate_hz / 2 / bins,
          .first = std::lround(band_from * bins),
          .last = std::lround(band_to * bins)};
}

struct StoredPart {
  const char* path;
  double impacts::Edges::*value;
  Range range;
};

constexpr StoredPart stored_parts[] = {
    {"/edges/lag_s", &impacts::Edges::lag_s, impacts::ranges::lag_s},
    {"/edges/exit", &impacts::Edges::exit, impacts::ranges::exit},
    {"/edges/spread", &impacts::Edges::spread, impacts::ranges::spread}};

}  // namespace

std::vector<impacts::Edges> edges_of_known(const signal::WindowSet& known, const EdgePrior& prior) {
  std::vector<KnownBearing> bearings = bearings_of(known);
  std::erase_if(bearings, [](const KnownBearing& bearing) { return bearing.size_mm == 0; });
  std::vector<SeenBearing> all;
  all.reserve(bearings.size());
  for (const KnownBearing& bearing : bearings) all.push_back(seen(known, bearing));
  const std::vector<impacts::Edges> found = fit_edges(all, band_of(known), prior);
  std::vector<impacts::Edges> edges(known.size());
  for (std::size_t b = 0; b < bearings.size(); ++b) {
    for (const std::size_t i : bearings[b].windows) edges[i] = found[b];
  }
  return edges;
}

void write(artefact::Writer& writer, const std::vector<impacts::Edges>& edges) {
  for (const StoredPart& part : stored_parts) {
    std::vector<double> values;
    values.reserve(edges.size());
    for (const impacts::Edges& one : edges) values.push_back(one.*part.value);
    writer.numbers(part.path, values);
  }
}

std::vector<impacts::Edges> read_edges(const artefact::Reader& reader, std::size_t windows) {
  std::vector<impacts::Edges> edges(windows);
  for (const StoredPart& part : stored_parts) {
    const std::vector<double> values = reader.numbers<double>(part.path, {windows}).values;
    reader.require_all(part.path, values, part.range);
    for (std::size_t i = 0; i < windows; ++i) edges[i].*part.value = values[i];
  }
  return edges;
}

}  // namespace piae::transfer
