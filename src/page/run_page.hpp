#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "page/document.hpp"
#include "report/document.hpp"
#include "run/step_log.hpp"

namespace piae::page {

/// Returns the processor time per seed of each method with a classifier: to train and generate,
/// then to train and apply the classifier, with the most generated windows that the run has of the
/// pair. Numbers are means over the seeds whose logs exist and whose steps finished without
/// interruption. Returns nothing if no diagnosis left a log.
std::optional<report::Section> cost_table(const std::vector<run::StepLog>& steps);

inline constexpr std::size_t most_listed_steps = 5000;

/// Returns run.html: when the steps ran, processor time and memory of each stage, and the slowest
/// steps. Two runs of the same settings differ in these numbers, so report.html does not have them.
/// `steps` are ordered by begin. Above most_listed_steps, lists only steps that are not done, and
/// at most that many.
std::string run_page(const std::vector<run::StepLog>& steps, const Style& style);

}  // namespace piae::page
