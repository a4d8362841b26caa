#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scoring/statistics.hpp"

namespace piae::report {

/// Format of a number in a table for people.
struct NumberStyle {
  int decimals = 2;
  bool sign = false;  ///< "+1.20", for differences
};

/// Format of percentages and their intervals.
inline constexpr NumberStyle percent_style{.decimals = 1};

std::string number_label(double number, NumberStyle style = {});
/// Return "85.40 ± 1.20" and "[84.01, 86.79]". A single repeat gives "85.40" and "–".
std::string mean_label(const scoring::Summary& summary, NumberStyle style = {});
std::string interval_label(const scoring::Summary& summary, NumberStyle style = {});

/// Returns "shift", or "oracle (ceiling)" for a ceiling (augment/catalogue.hpp).
std::string method_label(const std::string& method);
/// Returns the style of a method's row on a page: "ceiling", or "" for a method.
std::string looks_of(const std::string& method);

/// Returns a sentence on the mark of classifiers that adapt (diagnosis::marked_name()); "" if none
/// of these does.
std::string about_adapting(const std::vector<std::string>& classifiers);

/// Text of a cell without a number.
inline constexpr const char* no_number = "–";

/// Mark after a value that is based on fewer seeds than others of its table.
inline constexpr const char* mark_of_fewer_seeds = "‡";
std::string marked_if(bool fewer_seeds, const std::string& label);

/// A p up to this value is called significant.
inline constexpr double significance_level = 0.05;
/// Mark after a p that cannot be that small, whatever the data, because the seeds are too few.
inline constexpr const char* mark_of_large_p = "†";

/// Returns "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& words);

/// Returns "1 seed", "2 seeds". Forms the plural with an s.
std::string counted(std::size_t count, const std::string& word);

/// Returns "10:1" for the ratio 10to1.
std::string short_ratio_label(const std::string& name);

/// Returns "10:1", or "2:1 (3.33:1)" if the true ratio differs from the name, or "100:1 (no
/// faults)" without fault windows.
std::string ratio_label(const std::string& name, std::optional<double> true_ratio);

/// Returns a number with four decimals for CSV, or "" for no number.
std::string four_decimals(std::optional<double> number);

}  // namespace piae::report
