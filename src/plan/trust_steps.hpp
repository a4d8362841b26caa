#pragma once

#include "plan/table_steps.hpp"

namespace piae::plan {

/// Adds the steps that keep the classifiers of all cells, and the table that measures how far they
/// can be trusted.
///
///     <dataset>/seedK/METHOD/RATIO/CLASSIFIER/classifier.h5, <dataset>/trust.{csv,md}
void add_trust(TableSteps& tables);

}  // namespace piae::plan
