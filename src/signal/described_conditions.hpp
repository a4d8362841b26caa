#pragma once

#include <string>
#include <vector>

#include "signal/conditions.hpp"
#include "signal/description.hpp"
#include "signal/toml_table.hpp"

namespace piae::signal {

/// The name of a condition, which the key must hold. Throws Error(bad_input) for what is none.
std::string read_condition_name(TomlTable& table, const std::string& key);

/// What the names of all records of a class in one condition begin with: "IR2-900-rpm"; "IR2" where
/// they are of no condition.
std::string record_stem(const std::string& class_name, const std::string& condition);

/// The conditions that the records of a description name, in the order in which they do so first,
/// with what [transfer] says they are for:
///
///     [transfer]
///     known   = ["1200 rpm"]             # C comes from these
///     test    = ["900 rpm"]              # A and D come from these
///     healthy = ["1200 rpm", "900 rpm"]  # B; without it, from both of the above
///
/// Without [transfer] all conditions are for everything. Records of a condition that is for nothing
/// are removed.
///
/// Throws Error(bad_input) with file, line and key for a condition that no record has, one that is
/// both known and tested, a fault class without a known record or one to test with, and a tested
/// condition without a healthy record.
std::vector<Condition> read_described_conditions(TomlTable& root, const DatasetInfo& info,
                                                 std::vector<RecordSource>& records);

}  // namespace piae::signal
