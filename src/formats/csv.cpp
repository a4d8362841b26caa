#include "formats/csv.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "text/csv.hpp"

namespace piae::formats {

namespace {

template <class T>
std::string digits(T value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

/// Writes whole numbers without exponent: 100000, not 1e+05.
std::string number_text(double value) {
  constexpr double exact = 1e15;
  const bool whole = std::abs(value) < exact && value == std::floor(value);
  return whole ? digits(static_cast<std::int64_t>(value)) : digits(value);
}

std::string value_text(const Fact& fact, std::size_t i) {
  if (const auto* texts = std::get_if<Texts>(&fact.values)) return (*texts)[i];
  if (const auto* numbers = std::get_if<Numbers>(&fact.values)) return number_text((*numbers)[i]);
  std::string text;
  for (const double value : std::get<Lists>(fact.values)[i]) {
    text += (text.empty() ? "" : " ") + number_text(value);
  }
  return text;
}

enum class Samples { with, without };

std::string lines(const Exported& exported, Samples samples) {
  const Facts facts = facts_of(exported);
  const signal::WindowSet& windows = exported.windows;
  std::vector<std::string> fields;
  for (const auto* group : {&facts.of_all, &facts.of_each}) {
    for (const Fact& fact : *group) fields.push_back(fact.name);
  }
  if (samples == Samples::with) {
    for (std::size_t t = 0; t < windows.length; ++t) fields.push_back("x" + std::to_string(t));
  }
  std::string text = text::csv_line(fields);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    fields.clear();
    for (const Fact& fact : facts.of_all) fields.push_back(value_text(fact, 0));
    for (const Fact& fact : facts.of_each) fields.push_back(value_text(fact, i));
    if (samples == Samples::with) {
      for (const float x : windows.window(i)) fields.push_back(digits(x));
    }
    text += text::csv_line(fields);
  }
  return text;
}

}  // namespace

std::string csv(const Exported& exported) { return lines(exported, Samples::with); }

std::string labels_csv(const Exported& exported) { return lines(exported, Samples::without); }

}  // namespace piae::formats
