#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scoring/statistics.hpp"

namespace piae::report {

/// How numbers of a table for people are written.
struct NumberStyle {
  int decimals = 2;
  bool sign = false;  ///< "+1.20": for differences
};

/// Of percents and their intervals.
inline constexpr NumberStyle percent_style{.decimals = 1};

std::string number_label(double number, NumberStyle style = {});
/// "85.40 ± 1.20" and "[84.01, 86.79]". Of a single repeat "85.40"; where there is no interval "–".
std::string mean_label(const scoring::Summary& summary, NumberStyle style = {});
std::string interval_label(const scoring::Summary& summary, NumberStyle style = {});

/// "shift", or "oracle (ceiling)" for what is a ceiling and not a method (augment/catalogue.hpp).
std::string method_label(const std::string& method);
/// How a page shows the row of a method: "ceiling", or nothing of its own.
std::string looks_of(const std::string& method);

/// Stands in a table where there is no number.
inline constexpr const char* no_number = "–";

/// Stands after what is of fewer seeds than others of its table.
inline constexpr const char* mark_of_fewer_seeds = "‡";
std::string marked_if(bool fewer_seeds, const std::string& label);

/// From here down a p is called significant.
inline constexpr double significance_level = 0.05;
/// Stands after a p that so few seeds cannot make as small as that, whatever they show.
inline constexpr const char* mark_of_large_p = "†";

/// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& words);

/// "1 seed", "2 seeds". The plural of the word is made by an s.
std::string counted(std::size_t count, const std::string& word);

/// "10:1" for the ratio 10to1.
std::string short_ratio_label(const std::string& name);

/// How tables show a ratio of this name: "10:1", or "2:1 (3.33:1)" where the true ratio is not the
/// one that the name says; "100:1 (no faults)" where there was no window of a fault.
std::string ratio_label(const std::string& name, std::optional<double> true_ratio);

/// A number with four decimals, as CSV has it, or an empty field where there is none.
std::string four_decimals(std::optional<double> number);

}  // namespace piae::report
