#include "figures/trained_options.hpp"

#include <spdlog/fmt/fmt.h>

#include "base/numbers.hpp"

namespace piae::figures {

toml::table options_of_training(const artefact::Reader& model) {
  return toml::parse(model.strings("/provenance/options").at(0));
}

std::string shown_value(const std::string& value) {
  const auto number = number_in<double>(value);
  return number ? fmt::format("{:g}", *number) : value;
}

}  // namespace piae::figures
