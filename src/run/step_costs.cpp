#include "run/step_costs.hpp"

#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <ranges>

#include "text/csv.hpp"

namespace piae::run {

std::vector<StepCost> read_costs(const std::filesystem::path& file) {
  const std::vector<text::CsvLine> lines = text::read_csv(file);
  const std::vector<std::string> header{"stage", "dataset", "method",   "classifier",
                                        "ratio", "seconds", "megabytes"};
  if (lines.front().fields != header) {
    lines.front().refuse(fmt::format("the header must be {}", fmt::join(header, ",")));
  }
  std::vector<StepCost> costs;
  for (const text::CsvLine& line : lines | std::views::drop(1)) {
    const auto seconds = line.number(5);
    const auto megabytes = line.number(6);
    if (!seconds || !megabytes) line.refuse("seconds and megabytes must be numbers");
    costs.push_back({.stage = line.fields[0],
                     .dataset = line.fields[1],
                     .method = line.fields[2],
                     .classifier = line.fields[3],
                     .ratio = line.fields[4],
                     .seconds = *seconds,
                     .megabytes = *megabytes});
  }
  return costs;
}

std::optional<double> generator_seconds(const std::vector<StepCost>& costs,
                                        const std::string& dataset, const std::string& method) {
  double sum = 0;
  for (const char* const stage : {"train", "generate"}) {
    const auto found = std::ranges::find_if(costs, [&](const StepCost& cost) {
      return cost.stage == stage && cost.dataset == dataset && cost.method == method;
    });
    if (found == costs.end()) return std::nullopt;
    sum += found->seconds;
  }
  return sum;
}

}  // namespace piae::run
