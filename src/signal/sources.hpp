#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/label.hpp"
#include "base/random.hpp"
#include "signal/dataset_info.hpp"
#include "signal/roles.hpp"

namespace piae::signal {

/// Windows of a class by role.
struct Counts {
  std::size_t all = 0;    ///< of the class
  std::size_t test = 0;   ///< A
  std::size_t known = 0;  ///< C, of a fault class; may be 0
};

/// A role and the number of its windows.
struct Share {
  Role role;
  std::size_t count;
};

/// The records of a class in one condition, and the roles that get their windows, in order. Under
/// the blocked protocol this is also the order in time.
struct Source {
  std::int32_t condition = every_condition;
  /// Speed of records that belong to every condition, if those of the class have several speeds.
  std::optional<double> shaft_speed_rpm = {};
  std::vector<std::size_t> records;  ///< indices into the recordings
  std::vector<Share> shares;         ///< each with one window or more

  [[nodiscard]] std::size_t windows() const;
  [[nodiscard]] std::size_t count_of(Role role) const;
};

/// Returns a text such as "1797 rpm".
std::string speed_label(double speed_rpm);

/// Returns a name for messages: "dataset cwru, class IR007, condition 900 rpm".
std::string name_of(const DatasetInfo& info, Label label, const Source& source);

/// Class, condition and speed of a record.
struct RecordPlace {
  Label label = 0;
  std::int32_t condition = every_condition;
  double shaft_speed_rpm = 0;
};

/// Assigns the windows of a class to roles: healthy to A and B, a fault class to A, C and D. Each
/// role takes windows from its conditions and from records of every condition, as evenly as
/// possible. `stream` decides which sources give one window more. Records of every condition are
/// one source, or one for each speed, so that each tested speed also has healthy training windows.
/// A data set without conditions has one source.
///
/// Throws Error(bad_input) if a role finds no record.
std::vector<Source> sources_of(const DatasetInfo& info, Label label,
                               std::span<const RecordPlace> records, const Counts& counts,
                               const Stream& stream);

}  // namespace piae::signal
