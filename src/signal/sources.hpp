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

/// How many windows of a class go to each role.
struct Counts {
  std::size_t all = 0;    ///< of the class
  std::size_t test = 0;   ///< A
  std::size_t known = 0;  ///< C, of a fault class; it may be none
};

/// A role, and how many windows it gets.
struct Share {
  Role role;
  std::size_t count;
};

/// The records of a class in one condition, and what their windows are dealt out to, in this order.
/// It is the order in time, too, where the protocol is blocked.
struct Source {
  std::int32_t condition = every_condition;
  /// Of records that belong to every condition, where those of the class have several speeds.
  std::optional<double> shaft_speed_rpm = {};
  std::vector<std::size_t> records;  ///< indices into the recordings
  std::vector<Share> shares;         ///< none is empty

  [[nodiscard]] std::size_t windows() const;
  [[nodiscard]] std::size_t count_of(Role role) const;
};

/// "1797 rpm".
std::string speed_label(double speed_rpm);

/// "dataset cwru, class IR007, condition 900 rpm", for messages.
std::string name_of(const DatasetInfo& info, Label label, const Source& source);

/// Where a record belongs.
struct RecordPlace {
  Label label = 0;
  std::int32_t condition = every_condition;
  double shaft_speed_rpm = 0;
};

/// Deals a class out: the healthy one to A and B, a fault class to A, C and D. Each role takes its
/// windows from the conditions that are for it, and from records that belong to every condition, as
/// evenly as whole windows allow; which of them give one more is drawn from `stream`. Records that
/// belong to every condition are one source, or one for each of their speeds: what is tested at a
/// speed shall be known healthy at it. A dataset without conditions has one source.
///
/// Throws Error(bad_input) where a role finds no record.
std::vector<Source> sources_of(const DatasetInfo& info, Label label,
                               std::span<const RecordPlace> records, const Counts& counts,
                               const Stream& stream);

}  // namespace piae::signal
