#pragma once

#include <map>
#include <string>

#include "plan/step_states.hpp"

namespace piae::plan {

/// How far a run is, as a table of its cells by data set and method, with the time left.
///
/// A cell is a diagnosis or a score; where (k, c) are identified it is a model. It is failed or
/// running when its step or one that it waits for is. The time of steps that all methods wait for
/// has a line of its own. Times are those of one step after the other, by what such steps have
/// taken in this run.
std::string status_table(Plan& plan, const std::map<StepId, StepState>& states, Logs& logs);

/// The steps that run and those that failed, each with what its log says; empty where there are
/// none.
std::string listed_steps(const Plan& plan, const std::map<StepId, StepState>& states);

}  // namespace piae::plan
