#pragma once

#include <map>
#include <string>

#include "plan/step_states.hpp"

namespace piae::plan {

/// Returns the progress of a run as a table of its cells by data set and method, with the time
/// left.
///
/// A cell is a diagnosis or a score, or a model where (k, c) are identified. A cell counts as
/// failed or running if its step, or a step that it needs, is. Steps that all methods need have a
/// line of their own. The time left assumes one step at a time, at the durations of this run so
/// far.
std::string status_table(Plan& plan, const std::map<StepId, StepState>& states, Logs& logs);

/// Lists the running and the failed steps with the message of each; empty if there are none.
std::string listed_steps(const Plan& plan, const std::map<StepId, StepState>& states);

}  // namespace piae::plan
