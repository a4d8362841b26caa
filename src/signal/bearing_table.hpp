#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace piae::signal {

/// Keys of [bearing] for dimensions. A designation does not decide the last two.
inline constexpr std::array dimension_keys{"balls",
                                           "ball_diameter_mm",
                                           "pitch_diameter_mm",
                                           "contact_angle_deg",
                                           "inner_raceway_mm",
                                           "outer_raceway_mm"};
inline constexpr std::span geometry_keys = std::span(dimension_keys).first<4>();

/// Keys of [bearing] for fault frequencies at one turn per second.
inline constexpr std::array order_keys{"bpfo", "bpfi", "bsf", "ftf"};

/// Returns the keys of [bearing] that a table of bearings (pipeline/bearings.csv) has for a
/// designation: the geometry, or the orders if the row has no geometry. Ignores case, blanks and
/// hyphens. Some words of a designation are enough: "6205-2RS" finds "SKF 6205-2RS JEM". If no row
/// has these words, ignores seals, shields and clearance: "6205ZZ/C3" finds it, too. Returns the
/// first of several matching rows.
/// Throws Error(input_missing) without the table. Throws Error(bad_input) if no row matches, if
/// matching rows differ by more than 1 % in BPFO or BPFI, or if the table is damaged.
std::map<std::string, double> bearing_called(const std::string& designation,
                                             const std::filesystem::path& table);

/// Fault lines of a known bearing, as multiples of the shaft's speed.
struct BearingLines {
  std::string designation;
  double bpfo = 0;
  double bpfi = 0;
  std::optional<double> twice_bsf = {};  ///< empty if the table gives neither geometry nor BSF
};

/// Returns the lines of the rows of a table of bearings, in its order. Leaves out rows with neither
/// a whole geometry nor BPFO and BPFI. Returns nothing without the table.
/// Throws Error(bad_input) if the table is damaged.
std::vector<BearingLines> lines_of_bearings(const std::filesystem::path& table);

}  // namespace piae::signal
