#include "twin/curves.hpp"

#include <array>
#include <tuple>

namespace piae::twin {

namespace {

using Column = std::vector<double> Curves::*;

/// The squared discrepancy of equal windows may be slightly below 0 because of rounding.
constexpr Range loss{.low = -1e-6, .high = 1e300};
/// The logarithms in eq. 23 may have any sign.
constexpr Range total{.low = -1e300, .high = 1e300};
constexpr Range weight{.low = 0, .high = 1e300};

constexpr std::array<std::tuple<const char*, Column, Range>, 8> columns{{
    {"reconstruction", &Curves::reconstruction, loss},
    {"differential", &Curves::differential, loss},
    {"twin", &Curves::twin, loss},
    {"total", &Curves::total, total},
    {"alpha", &Curves::alpha, weight},
    {"beta", &Curves::beta, weight},
    {"gamma", &Curves::gamma, weight},
    {"learning_rate", &Curves::learning_rate, weight},
}};

}  // namespace

void Curves::write(artefact::Writer& writer) const {
  for (const auto& [name, column, range] : columns) {
    writer.numbers(std::string("/curves/") + name, this->*column);
  }
}

void Curves::read(const artefact::Reader& reader) {
  for (const auto& [name, column, range] : columns) {
    const std::string path = std::string("/curves/") + name;
    this->*column = reader.numbers<double>(path, {0}).values;
    reader.require_all(path, this->*column, range);
    if ((this->*column).size() != reconstruction.size()) {
      reader.refuse(path, "is not as long as /curves/reconstruction");
    }
  }
}

}  // namespace piae::twin
