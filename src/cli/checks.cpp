#include "cli/checks.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/numbers.hpp"

namespace piae::cli {

namespace {

bool is_whole(double x) { return x == std::floor(x); }

}  // namespace

Check number(std::string shown, std::string wanted, std::function<bool(double)> good) {
  const auto refusal = [wanted = std::move(wanted),
                        good = std::move(good)](const std::string& text) {
    const std::optional<double> value = number_in<double>(text);
    const bool is_good = value && std::isfinite(*value) && good(*value);
    return is_good ? std::string() : "'" + text + "' is not " + wanted;
  };
  return {std::move(shown), refusal};
}

Check positive_number() {
  return number("POSITIVE", "a positive number", [](double x) { return x > 0; });
}

Check non_negative_number() {
  return number("NONNEGATIVE", "zero or a positive number", [](double x) { return x >= 0; });
}

Check share() {
  return number("[0 - 1]", "a number from 0 to 1", [](double x) { return x >= 0 && x <= 1; });
}

Check within(const Range& range) {
  return number(fmt::format("[{:g} - {:g}]", range.low, range.high),
                fmt::format("a number from {:g} to {:g}{}", range.low, range.high, range.unit),
                [range](double x) { return range.holds(x); });
}

Check natural_number() {
  constexpr double most = 1e15;  // above this, a double cannot hold every whole number
  return number("NATURAL", "a whole number from 0 to 10^15",
                [](double x) { return x >= 0 && x <= most && is_whole(x); });
}

Check whole_number(std::int64_t least, std::int64_t most) {
  return number(fmt::format("[{} - {}]", least, most),
                fmt::format("a whole number from {} to {}", least, most), [least, most](double x) {
                  return is_whole(x) && x >= static_cast<double>(least) &&
                         x <= static_cast<double>(most);
                });
}

Check one_of(const std::vector<std::string>& words) {
  const auto refusal = [words](const std::string& text) {
    const bool good = std::ranges::find(words, text) != words.end();
    return good ? std::string()
                : fmt::format("'{}' is not one of: {}", text, fmt::join(words, ", "));
  };
  return {fmt::format("{{{}}}", fmt::join(words, ",")), refusal};
}

}  // namespace piae::cli
