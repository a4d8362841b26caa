#include "raw/tdms_scales.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <optional>

namespace piae::raw {

namespace {

/// Coefficients of a polynomial, constant first.
using Polynomial = std::vector<double>;

constexpr double raw_values = 0xFFFFFFFF;  ///< source of a scale that takes raw values

double value_at(const Polynomial& polynomial, double x) {
  double value = 0;
  for (std::size_t i = polynomial.size(); i-- > 0;) value = value * x + polynomial[i];
  return value;
}

class Scales {
 public:
  Scales(const Where& where, const TdmsProperties& properties)
      : where_(where), properties_(properties) {}

  TdmsScales run() {
    const double count = number("NI_Number_Of_Scales").value_or(count_by_names());
    if (!(count > 0) || text("NI_Scaling_Status") == "scaled") return {};
    std::vector<Polynomial> chain;  // last scale first
    double below = count;           // a scale's source is an earlier scale
    for (double scale = count - 1; scale != raw_values;) {
      if (!(scale >= 0 && scale < below)) {
        refuse(where_, "is damaged: the source of a scale does not exist");
      }
      below = scale;
      add(chain, scale);
    }
    std::ranges::reverse(chain);
    return [chain](double x) {
      for (const Polynomial& polynomial : chain) x = value_at(polynomial, x);
      return x;
    };
  }

 private:
  static std::string prefix(double scale) { return fmt::format("NI_Scale[{:.0f}]_", scale); }

  [[nodiscard]] double count_by_names() const {
    double count = 0;
    while (properties_.contains(prefix(count) + "Scale_Type")) ++count;
    return count;
  }

  /// Adds a scale and sets `scale` to its source.
  void add(std::vector<Polynomial>& chain, double& scale) {
    const std::string name = prefix(scale);
    const std::string type = text(name + "Scale_Type");
    if (type == "Linear") {
      chain.push_back({required(name + "Linear_Y_Intercept"), required(name + "Linear_Slope")});
    } else if (type == "Polynomial") {
      chain.push_back(polynomial(name + "Polynomial_Coefficients"));
    } else {
      refuse(where_, fmt::format("has a scale of the type '{}', which is not supported; save its "
                                 "scaled values as CSV with DIAdem, LabVIEW or npTDMS",
                                 type));
    }
    scale = number(name + type + "_Input_Source").value_or(raw_values);
  }

  [[nodiscard]] Polynomial polynomial(const std::string& name) const {
    constexpr double most = 100;
    const double count = number(name + "_Size").value_or(4);
    if (!(count >= 0 && count <= most)) {
      refuse(where_, "is damaged: its polynomial has an invalid size");
    }
    Polynomial coefficients;
    for (int i = 0; i < count; ++i)
      coefficients.push_back(required(fmt::format("{}[{}]", name, i)));
    return coefficients;
  }

  [[nodiscard]] std::optional<double> number(const std::string& name) const {
    const auto found = properties_.find(name);
    if (found == properties_.end()) return std::nullopt;
    const auto* const value = std::get_if<double>(&found->second);
    return value == nullptr ? std::nullopt : std::optional(*value);
  }

  [[nodiscard]] double required(const std::string& name) const {
    const auto value = number(name);
    if (!value) refuse(where_, "is damaged: its scale has no " + name);
    return *value;
  }

  [[nodiscard]] std::string text(const std::string& name) const {
    const auto found = properties_.find(name);
    if (found == properties_.end()) return "";
    const auto* const value = std::get_if<std::string>(&found->second);
    return value == nullptr ? "" : *value;
  }

  const Where& where_;
  const TdmsProperties& properties_;
};

}  // namespace

TdmsScales tdms_scales(const Where& where, const TdmsProperties& properties) {
  return Scales(where, properties).run();
}

}  // namespace piae::raw
