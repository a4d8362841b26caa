#include "scoring/ratios.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "base/comma_list.hpp"
#include "base/error.hpp"

namespace piae::scoring {

namespace {

constexpr std::array<Ratio, 7> table_5{{{"100to1", 0},
                                        {"50to1", 5},
                                        {"25to1", 15},
                                        {"10to1", 45},
                                        {"5to1", 95},
                                        {"2to1", 145},
                                        {"1to1", 495}}};

}  // namespace

std::span<const Ratio> all_ratios() { return table_5; }

std::string list_of_ratios() {
  return comma_list(table_5, [](const Ratio& ratio) {
    return std::string(ratio.name) + " (" + std::to_string(ratio.generated_per_class) + ")";
  });
}

const Ratio& find_ratio(const std::string& name) {
  const auto found = std::ranges::find(table_5, name, &Ratio::name);
  if (found != std::end(table_5)) return *found;
  throw Error(Exit::usage,
              "unknown ratio '" + name + "'; known: " + comma_list(table_5, &Ratio::name));
}

std::optional<double> true_ratio(std::int64_t normal_windows, std::int64_t known_per_class,
                                 std::int64_t generated_per_class) {
  if (known_per_class + generated_per_class == 0) return std::nullopt;
  return static_cast<double>(normal_windows) /
         static_cast<double>(known_per_class + generated_per_class);
}

}  // namespace piae::scoring
