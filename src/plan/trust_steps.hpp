#pragma once

#include "plan/table_steps.hpp"

namespace piae::plan {

/// Puts the steps into a graph that keep the classifiers of all cells, and the table that says how
/// far to believe them.
///
///     <dataset>/seedK/METHOD/RATIO/CLASSIFIER/classifier.h5, <dataset>/trust.{csv,md}
void add_trust(TableSteps& tables);

}  // namespace piae::plan
