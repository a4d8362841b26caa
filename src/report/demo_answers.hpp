#pragma once

#include <string>
#include <vector>

#include "report/accuracies.hpp"
#include "run/collect.hpp"

namespace piae::report {

/// Report of `classify` on one recording.
struct NamedRecording {
  std::string file;   ///< "recording.txt"
  std::string named;  ///< the class, or "unknown"
  bool correct = false;
};

/// Measurements of `make demo`. Each list holds the cells of one data set.
struct DemoCells {
  std::vector<run::Diagnosis> same_speed;   ///< faults known at the speed they are tested at
  std::vector<run::Diagnosis> other_speed;  ///< faults known at one speed, tested at another
  std::vector<run::Diagnosis> no_fault;     ///< no known fault window
  NamedRecording recording;
};

/// A method helps if it adds at least this much, in points, in every seed.
inline constexpr double points_of_help = 5;
/// Generated windows are unnecessary if a classifier without them is at most this much below the
/// best method, in points.
inline constexpr double points_of_no_need = 1;
/// A rule that is correct this often, in percent, can diagnose.
inline constexpr double percent_of_a_diagnosis = 80;

/// True if `row` helps in comparison with `alone`, its classifier without generated windows. False
/// if they have no seed in common.
bool helps(const AccuracyRow& row, const AccuracyRow& alone);

/// Returns the three questions of the demo, each with its answer, in lines of at most 80
/// characters. The numbers decide every verdict. Percentages are whole numbers: rounding errors
/// differ between processors and move the last digits of a trained network's accuracy. Throws
/// Error(input_missing) if the cells of a question are missing.
std::string demo_answers(const DemoCells& cells);

}  // namespace piae::report
