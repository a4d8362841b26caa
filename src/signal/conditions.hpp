#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"

namespace piae::signal {

/// The condition of a window or a record that belongs to every condition.
inline constexpr std::int32_t every_condition = -1;

/// A state of the machine that a data set tells apart: a speed, a load, a size of the defects, a
/// rig. What a description says in [transfer] decides what its windows may be used for; without
/// [transfer] they may be used for everything.
struct Condition {
  std::string name;            ///< "900 rpm"
  double shaft_speed_rpm = 0;  ///< mean of its records' speeds
  bool known = true;           ///< known fault windows (C) come from it
  bool test = true;            ///< test windows and those to compare with (A and D) come from it
  bool healthy = true;         ///< healthy windows (B) come from it

  bool operator==(const Condition&) const = default;
};

/// Whether the faults that are tested are known in other conditions alone.
bool is_transfer(std::span<const Condition> conditions);

/// What a condition may be called: letters, digits, '-', '_', '.' and spaces within.
bool is_condition_name(const std::string& name);
inline const std::string condition_name_rule =
    "may hold letters, digits, '-', '_', '.' and single spaces between them, at most 100";

/// In the artefact, where a data set has conditions: /conditions/name, /conditions/shaft_speed_rpm
/// and, as 0 or 1, /conditions/known, /conditions/test, /conditions/healthy.
void write(artefact::Writer& writer, std::span<const Condition> conditions);
/// Empty where the artefact names none. Throws artefact::Refusal for what no description can say.
std::vector<Condition> read_conditions(const artefact::Reader& reader);

}  // namespace piae::signal
