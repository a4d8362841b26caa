#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"

namespace piae::signal {

/// Condition index of a window or a record that belongs to every condition.
inline constexpr std::int32_t every_condition = -1;

/// A state of the machine that a data set distinguishes: a speed, a load, a defect size, a rig.
/// [transfer] in the description sets the use of its windows; without [transfer] every use is
/// allowed.
struct Condition {
  std::string name;            ///< "900 rpm"
  double shaft_speed_rpm = 0;  ///< mean of its records' speeds
  bool known = true;           ///< source of known fault windows (C)
  bool test = true;            ///< source of test windows (A) and hidden windows (D)
  bool healthy = true;         ///< source of healthy windows (B)

  bool operator==(const Condition&) const = default;
};

/// True if some condition is only known or only tested.
bool is_transfer(std::span<const Condition> conditions);

/// True if a condition may have this name: letters, digits, '-', '_', '.' and inner spaces.
bool is_condition_name(const std::string& name);
inline const std::string condition_name_rule =
    "may hold letters, digits, '-', '_', '.' and single spaces between them, at most 100";

/// Writes /conditions/name, /conditions/shaft_speed_rpm and, as 0 or 1, /conditions/known,
/// /conditions/test and /conditions/healthy. Writes nothing without conditions.
void write(artefact::Writer& writer, std::span<const Condition> conditions);
/// Returns an empty list if the artefact has no conditions. Throws artefact::Refusal for values
/// that a description cannot have.
std::vector<Condition> read_conditions(const artefact::Reader& reader);

}  // namespace piae::signal
