#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "signal/window_set.hpp"

namespace piae::scoring {

/// Quality of the generated windows of one class, compared with the real ones of D.
struct ClassQuality {
  Label label = 0;
  std::int64_t windows = 0;             ///< compared in each set: the smaller of both counts
  double mmd = 0;                       ///< MMD^2, no unit, see scoring/mmd.hpp
  double rmse = 0;                      ///< eq. 28, in the unit of the recordings
  double aligned_rmse = 0;              ///< in the unit of the recordings, see scoring/waveform.hpp
  double amplitude_ratio = 0;           ///< RMS, generated to real
  double spectral_distance_db = 0;      ///< see scoring/waveform.hpp
  double fault_line_db = 0;             ///< of the generated windows, see spectra/lines.hpp
  double fault_line_difference_db = 0;  ///< generated minus real
};

/// One of the numbers of ClassQuality, with its descriptions.
struct Metric {
  const char* name;  ///< in files
  double ClassQuality::*value;
  const char* title;    ///< in tables
  const char* meaning;  ///< how to interpret it, in sentences
  bool in_paper;        ///< true if the paper draws it (Figs 13, 14, 16 and 17, without numbers)
  int decimals = 4;     ///< largest number of decimals in tables
  bool is_of_line = false;  ///< true for a metric of the fault line; 0 for a class without line
};

/// True if a class has a fault line, because its defect is one of the bearing.
bool has_line(const signal::DatasetInfo& info, Label label);

std::span<const Metric> all_metrics();

/// Compares generated windows with real ones, class by class. The first n windows of each class of
/// both sets are compared, in their stored order, where n is the smaller count. The bandwidth of
/// the MMD comes from all real windows of the class. Throws Error(bad_input) if the sets differ in
/// data set or window length, if a class is in one set only, and if the real windows of a class do
/// not allow a comparison: fewer than two, all the same, or constant.
std::vector<ClassQuality> quality_by_class(const signal::WindowSet& generated,
                                           const signal::WindowSet& real);

}  // namespace piae::scoring
