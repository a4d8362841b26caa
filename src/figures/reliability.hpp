#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"
#include "report/classifier_rows.hpp"

namespace piae::figures {

/// Whether the classifier is right as often as its score says: the test windows of all
/// seeds in ten bins by the score of the class that was named, of each method at its ratio with the
/// most generated windows. Columns: method,ceiling,ratio,kind,score_from,score_to,windows,share,
/// mean_score,accuracy,gap, all but `windows` in percent. `share` is that of all windows, `gap` the
/// distance of accuracy and mean score; an empty bin has none. After the rows of `kind` "bin" comes
/// one of kind "all", whose gap is the expected calibration error. Throws LeftOut where the
/// classifier names a class and not how sure it is.
Numbers reliabilities(Source& source, const report::ClassifierRows& shown);

}  // namespace piae::figures
