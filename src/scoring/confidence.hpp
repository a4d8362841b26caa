#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "scoring/calibration.hpp"
#include "scoring/diagnosis_record.hpp"

namespace piae::scoring {

/// Required share of correct predictions, in percent.
inline constexpr std::size_t wanted_precision_percent = 95;
/// Number of bins of a reliability diagram.
inline constexpr std::size_t reliability_bins = 10;

/// Quality of one classifier's certainty.
struct Confidence {
  double calibration_error = 0;  ///< in [0, 1]: expected_calibration_error()
  double answerable = 0;         ///< in [0, 1]: answerable_share() at wanted_precision_percent
  bool ranks_answers = false;    ///< see ranks_answers()
};

/// Returns the largest score of each window, row-major [n, classes], and whether its predicted
/// class is the true one.
std::vector<Judgement> judgements_of(std::span<const float> scores, std::span<const Label> named,
                                     std::span<const Label> labels);
/// Returns the judgement of each test window.
std::vector<Judgement> judgements_of(const DiagnosisRecord& record);

/// True if a classifier is more certain of some windows than of others. Otherwise, for example if
/// it gives only a class, all windows get a prediction or none does.
bool ranks_answers(std::span<const Judgement> judgements);

/// Throws std::logic_error for a diagnosis without windows.
Confidence confidence_of(const DiagnosisRecord& record);

}  // namespace piae::scoring
