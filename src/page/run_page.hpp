#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "page/document.hpp"
#include "report/document.hpp"
#include "run/step_log.hpp"

namespace piae::page {

/// The processor time that a method with a classifier takes of one seed: to train and to generate,
/// and then to train the classifier and to ask it, with the most generated windows that the run has
/// of this pair. The mean over the seeds whose logs are there and whose steps were done in one go.
/// Empty where no diagnosis has left its log.
std::optional<report::Section> cost_table(const std::vector<run::StepLog>& steps);

inline constexpr std::size_t most_listed_steps = 5000;

/// run.html: when the steps of a run ran, how much processor time and memory each stage took, and
/// which steps were the slowest. Two runs of the same settings give different pages, which is why
/// none of this stands in report.html. `steps` are ordered by begin. Of more than
/// most_listed_steps, only those have a row of their own that are not done, as many as that.
std::string run_page(const std::vector<run::StepLog>& steps, const Style& style);

}  // namespace piae::page
