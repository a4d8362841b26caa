#pragma once

#include <string>
#include <vector>

#include "signal/conditions.hpp"
#include "signal/description.hpp"
#include "signal/toml_table.hpp"

namespace piae::signal {

/// Largest over smallest speed of a condition. A drive that is set to one speed may turn by some
/// percent faster or slower with each bearing; beyond that, it is another condition, or a slip of
/// the pen.
inline constexpr double largest_speed_ratio = 1.1;

/// Reads the name of a condition. Throws Error(bad_input) for an invalid name.
std::string read_condition_name(TomlTable& table, const std::string& key);

/// Returns the start of the names of all records of a class in one condition: "IR2-900-rpm", or
/// "IR2" without a condition.
std::string record_stem(const std::string& class_name, const std::string& condition);

/// Returns the conditions of the records in order of first appearance, with their uses from
/// [transfer]:
///
///     [transfer]
///     known   = ["1200 rpm"]             # C comes from these
///     test    = ["900 rpm"]              # A and D come from these
///     healthy = ["1200 rpm", "900 rpm"]  # B; without it, from both of the above
///
/// If no fault is known (known-per-class is 0), `known` must be missing, and counts as `test`.
/// Without [transfer] every condition has every use. Removes records of a condition without a use.
///
/// Throws Error(bad_input) with file, line and key for a condition that no record has, a condition
/// both known and tested, a fault class without a known or a test record, and a tested condition
/// without a healthy record.
std::vector<Condition> read_described_conditions(TomlTable& root, const DatasetInfo& info,
                                                 std::vector<RecordSource>& records,
                                                 bool any_known);

/// Returns the mean speed of the records of a condition, which must have some.
double mean_speed_of_records_rpm(const std::vector<RecordSource>& records,
                                 const std::string& condition);

}  // namespace piae::signal
