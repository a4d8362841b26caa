#pragma once

#include <optional>
#include <vector>

#include "report/document.hpp"
#include "run/step_log.hpp"

namespace piae::page {

/// The processor time that a method with a classifier takes of one seed: to train and to generate,
/// and then to train the classifier and to ask it, with the most generated windows that the run has
/// of this pair. The mean over the seeds whose logs are there and whose steps were done in one go.
/// Empty where no diagnosis has left its log.
std::optional<report::Section> cost_table(const std::vector<run::StepLog>& steps);

}  // namespace piae::page
