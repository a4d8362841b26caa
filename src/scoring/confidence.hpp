#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "scoring/calibration.hpp"
#include "scoring/diagnosis_record.hpp"

namespace piae::scoring {

/// Of a hundred answers so many must be right.
inline constexpr std::size_t wanted_precision_percent = 95;
/// Bins of a reliability diagram.
inline constexpr std::size_t reliability_bins = 10;

/// Whether one classifier knows when it does not know.
struct Confidence {
  double calibration_error = 0;  ///< in [0, 1]: expected_calibration_error()
  double answerable = 0;         ///< in [0, 1]: answerable_share() at wanted_precision_percent
  bool tells = false;            ///< see tells()
};

/// The largest score of each window, row-major [n, classes], and whether the class that was named
/// is the true one.
std::vector<Judgement> judgements_of(std::span<const float> scores, std::span<const Label> named,
                                     std::span<const Label> labels);
/// Of each test window.
std::vector<Judgement> judgements_of(const DiagnosisRecord& record);

/// Whether a classifier is surer of some windows than of others. Where it is not, as where it names
/// a class and says nothing more, all windows are answered, or none.
bool tells(std::span<const Judgement> judgements);

/// Throws std::logic_error for a diagnosis of no window.
Confidence confidence_of(const DiagnosisRecord& record);

}  // namespace piae::scoring
