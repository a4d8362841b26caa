#include "twin/curves.hpp"

#include <array>
#include <utility>

namespace piae::twin {

namespace {

using Column = std::vector<double> Curves::*;

constexpr std::array<std::pair<const char*, Column>, 8> columns{{
    {"reconstruction", &Curves::reconstruction},
    {"differential", &Curves::differential},
    {"twin", &Curves::twin},
    {"total", &Curves::total},
    {"alpha", &Curves::alpha},
    {"beta", &Curves::beta},
    {"gamma", &Curves::gamma},
    {"learning_rate", &Curves::learning_rate},
}};

}  // namespace

void Curves::write(artefact::Writer& writer) const {
  for (const auto& [name, column] : columns) {
    writer.numbers(std::string("/curves/") + name, this->*column);
  }
}

void Curves::read(const artefact::Reader& reader) {
  for (const auto& [name, column] : columns) {
    this->*column = reader.numbers<double>(std::string("/curves/") + name, {0}).values;
  }
}

}  // namespace piae::twin
