#include "figures/protocols.hpp"

#include <algorithm>
#include <filesystem>

#include "augment/catalogue.hpp"
#include "figures/intervals.hpp"

namespace piae::figures {

namespace {

namespace fs = std::filesystem;

/// The part of a grid that a run has begun: of its seeds and of its methods and ratios those of
/// which there is any cell.
run::Grid begun_part(const run::Grid& grid, const run::Layout& layout) {
  const auto there_is = [&](const run::Combination& cell, std::int64_t seed) {
    return fs::exists(layout.diagnosis(cell.method, cell.ratio, seed));
  };
  run::Grid part{.dataset = grid.dataset, .scored = {}, .combinations = {}, .seeds = {}};
  std::ranges::copy_if(
      grid.combinations, std::back_inserter(part.combinations), [&](const run::Combination& cell) {
        return std::ranges::any_of(grid.seeds, [&](auto seed) { return there_is(cell, seed); });
      });
  std::ranges::copy_if(grid.seeds, std::back_inserter(part.seeds), [&](std::int64_t seed) {
    return std::ranges::any_of(part.combinations,
                               [&](const auto& cell) { return there_is(cell, seed); });
  });
  return part;
}

/// The split of a run, of which its first cell tells.
signal::Protocol protocol_of(const Source& source) {
  return source.diagnosis(source.grid().combinations.front(), source.grid().seeds.front()).protocol;
}

void add_side(Numbers& numbers, Source& side) {
  const std::string protocol = to_string(protocol_of(side));
  for (const report::AccuracyRow& row : side.accuracy_rows()) {
    const std::string ceiling = augment::is_ceiling(row.method) ? "1" : "0";
    for (std::size_t i = 0; i < row.values.size(); ++i) {
      numbers.row({row.method, ceiling, row.ratio, protocol, std::to_string(side.grid().seeds[i]),
                   digits(row.values[i]), "", ""});
    }
    const std::vector<std::string> interval = shown_interval(row.summary);
    numbers.row({row.method, ceiling, row.ratio, protocol, "mean", digits(row.summary.mean),
                 interval[0], interval[1]});
  }
}

}  // namespace

Numbers protocols(Source& source) {
  const run::Layout beside = source.layout().blocked();
  const run::Grid grid = begun_part(source.grid(), beside);
  if (grid.combinations.empty()) {
    throw LeftOut("there is no run with the other split (make contrast): " +
                  beside.folder().string());
  }
  Source here(source.layout(), grid, report::Published());
  Source there(beside, grid, report::Published());
  if (protocol_of(here) == protocol_of(there)) {
    throw Error(Exit::bad_input, beside.folder().string() + ": its split is " +
                                     to_string(protocol_of(there)) + ", as that of the run itself");
  }
  Numbers numbers({"method", "ceiling", "ratio", "protocol", "seed", "accuracy", "low", "high"});
  add_side(numbers, here);
  add_side(numbers, there);
  return numbers;
}

}  // namespace piae::figures
