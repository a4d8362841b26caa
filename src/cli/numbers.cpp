#include "cli/numbers.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdint>
#include <string>

namespace piae::cli {

namespace {

/// A check on a finite number; `wanted` says what it must be.
template <class Condition>
CLI::Validator number(const std::string& shown, const std::string& wanted, Condition condition) {
  const auto check = [wanted, condition](std::string& text) -> std::string {
    double value = 0;
    const bool good =
        CLI::detail::lexical_cast(text, value) && std::isfinite(value) && condition(value);
    return good ? std::string() : "'" + text + "' is not " + wanted;
  };
  return {check, shown};
}

}  // namespace

CLI::Validator positive_number() {
  return number("POSITIVE", "a positive number", [](double x) { return x > 0; });
}

CLI::Validator non_negative_number() {
  return number("NONNEGATIVE", "zero or a positive number", [](double x) { return x >= 0; });
}

CLI::Validator share() {
  return number("[0 - 1]", "a number from 0 to 1", [](double x) { return x >= 0 && x <= 1; });
}

CLI::Validator natural_number() {
  constexpr double most = 1e15;  // beyond, a double does not hold every whole number
  return number("NATURAL", "a whole number from 0 to 10^15",
                [](double x) { return x >= 0 && x <= most && x == std::floor(x); });
}

}  // namespace piae::cli
