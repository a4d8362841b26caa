#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "signal/window_set.hpp"

namespace piae::scoring {

/// How good the generated windows of one class are, against the real ones in D.
struct ClassQuality {
  std::int32_t label = 0;
  std::int64_t windows = 0;  ///< of each kind that were compared: the smaller of both counts
  double mmd = 0;            ///< MMD^2, see scoring/mmd.hpp
  double rmse = 0;           ///< eq. 28, in the unit of the recordings
  double aligned_rmse = 0;
  double amplitude_ratio = 0;
  double spectral_distance_db = 0;
  double fault_line_db = 0;             ///< of the generated windows, see scoring/envelope.hpp
  double fault_line_difference_db = 0;  ///< that minus that of the real ones
};

/// A metric of ClassQuality.
struct Metric {
  const char* name;  ///< in files
  double ClassQuality::*value;
  const char* title;    ///< in tables
  const char* meaning;  ///< how to read it, in sentences
  bool in_paper;        ///< the paper shows it, in Figs 13, 14, 16 and 17, without numbers
  int decimals = 4;     ///< in tables, no more than these
};
std::span<const Metric> all_metrics();

/// Compares generated windows with real ones, class by class: the first n of a class with the first
/// n, in the order in which they are stored, where n is the smaller of both counts. The MMD's
/// bandwidth comes from all real windows of the class. Throws Error(bad_input) when the two are not
/// of the same dataset and window length, or a class is in one and not in the other, or the real
/// windows of a class cannot be a reference (fewer than two, all the same, or silent but for their
/// mean).
std::vector<ClassQuality> judge(const signal::WindowSet& generated, const signal::WindowSet& real);

}  // namespace piae::scoring
